export const modes = ["orbit", "walk", "fly", "top"] as const;
export type Mode = (typeof modes)[number];
