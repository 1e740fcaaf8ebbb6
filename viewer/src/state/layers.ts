// What may be laid over the store.
export const layerNames = ["zones", "aisles", "violations"] as const;
export type LayerName = (typeof layerNames)[number];
