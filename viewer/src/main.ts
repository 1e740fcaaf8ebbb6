// Starts the page: the summary first, then the picture, then everything else as it comes.
import { App } from "./app";
import { loadGoods, loadRest } from "./loader";
import { readDrivePlace } from "./drive/addresses";
import { offerDriving, startDriving } from "./drive/start";
import { EditClient } from "./edit/client";
import { makeLink, readMakePlace } from "./make/addresses";
import { startMaking } from "./make/start_page";
import { readReplayPlace } from "./replay/addresses";
import { offerEpisodes, startReplay } from "./replay/start";
import { ServerError } from "./store/client";
import { Stage } from "./stage/stage";
import { WarmUp } from "./stage/warm_up";
import { Speech } from "./ui/speech";
import { Status } from "./ui/status";

// What tests and measurements read; nothing in the page depends on it.
interface Watched {
  marketgen?: { stage: Stage; app?: App; times: Record<string, number> };
}

async function start(): Promise<void> {
  const speech = new Speech();
  const status = new Status(speech);
  const replay = readReplayPlace(location.search);
  if (replay) {
    document.body.append(status.progress, status.note, status.fault);
    return startReplay(replay, speech, status).catch((error: unknown) => status.stop(error));
  }
  const driving = readDrivePlace(location.search);
  if (driving) {
    document.body.append(status.progress, status.note, status.fault);
    return startDriving(driving, speech, status).catch((error: unknown) => status.stop(error));
  }
  const making = readMakePlace(location.search);
  if (making) {
    document.body.append(status.progress, status.note, status.fault);
    return startMaking(making, speech, status).catch((error: unknown) => status.stop(error));
  }
  const address = new URLSearchParams(location.search);
  const store = Number(address.get("store") ?? 0) || 0;
  const client = new EditClient(store, address.get("token"));
  for (const path of ["", "/goods.bin"]) client.ahead(path); // WebGL takes a while to begin
  document.body.append(status.progress, status.note, status.fault);
  const stage = Stage.create();
  if (!stage) return status.stop(new Error(speech.say("noWebgl")));
  const { canvas } = stage;
  document.body.prepend(canvas);
  document.body.classList.add("early"); // panels wait: drawing them would hold up the first picture
  const warm = new WarmUp(stage);
  const times: Record<string, number> = {};
  const watched = ((window as Watched).marketgen = { stage, times } as NonNullable<Watched["marketgen"]>);

  try {
    status.work(0.05, speech.say("loading"));
    const summary = await client.summary();
    warm.draw();
    const app = (watched.app = new App(client, stage, summary, speech, status));
    new ResizeObserver(() => stage.resize()).observe(canvas);
    stage.resize();
    const loop = (now: number): void => {
      app.frame(now);
      requestAnimationFrame(loop);
    };
    requestAnimationFrame(loop);
    const watch = {
      step: (share: number | undefined) => status.work(share, speech.say("loading")),
      shown: (what: string) => (times[what] = performance.now()),
    };
    offerEpisodes({ store, token: address.get("token") }, speech, document.querySelector(".search header")).catch((error: unknown) => status.say(status.textOf(error)));
    if (summary.may_drive) offerDriving({ store, token: address.get("token") }, speech, document.querySelector(".search header"));
    const goods = await loadGoods(client, stage, summary, watch);
    app.restore();
    await stage.drawn(); // nothing else holds up the first picture
    times["picture"] = performance.now();
    warm.end();
    document.body.classList.remove("early");
    await loadRest(client, stage, goods, summary, watch);
    stage.complete();
    times["complete"] = performance.now();
  } catch (error) {
    document.body.classList.remove("early");
    // A server without stores makes some.
    if (error instanceof ServerError && error.code === "server.not_found" && !address.has("store")) return location.replace(makeLink(address.get("token")));
    status.stop(error);
  }
}

void start();
