import type { Stage } from '../stage/Stage';
import { createStageFrames, type StageFrames } from './StageFrames';

/** The end of a competitor's key that names another build of the Lab, beside the page under this name. */
export const AGAINST = '@against';

/** Frames of this build and, for competitors whose key ends in {@link AGAINST}, of the one under `against/`. */
export function framesOfBuilds(
  parent: HTMLElement,
  make: (parent: HTMLElement, url?: string) => StageFrames = createStageFrames,
): StageFrames {
  const own = make(parent);
  let other: StageFrames | null = null;
  let ownScene: Uint8Array | null = null;
  return {
    async stageOf(competitor) {
      if (!competitor.endsWith(AGAINST)) return own.stageOf(competitor);
      if (!other) {
        other = make(parent, './against/stage.html');
        if (ownScene) await other.setOwnScene(ownScene);
      }
      return withoutEnd(await other.stageOf(nameOf(competitor)));
    },
    async setOwnScene(file) {
      ownScene = file;
      await Promise.all([own.setOwnScene(file), other?.setOwnScene(file)]);
    },
    close() {
      own.close();
      other?.close();
    },
  };
}

const nameOf = (competitor: string): string => competitor.slice(0, -AGAINST.length);

/** A stage that is asked for competitors by keys that end in {@link AGAINST}. */
function withoutEnd(stage: Stage): Stage {
  return {
    open: (competitor, labCase, options) => stage.open(nameOf(competitor), labCase, options),
    turn: (competitor, ms) => stage.turn(nameOf(competitor), ms),
    count: (competitor) => stage.count(nameOf(competitor)),
    passes: (competitor) => stage.passes(nameOf(competitor)),
    addLights: (competitor) => stage.addLights(nameOf(competitor)),
    changeTechnique: (competitor) => stage.changeTechnique(nameOf(competitor)),
    close: (competitor) => stage.close(nameOf(competitor)),
    unavailable: (competitor) => stage.unavailable(nameOf(competitor)),
    setOwnScene: (file) => stage.setOwnScene(file),
    device: () => stage.device(),
  };
}
