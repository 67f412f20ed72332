import type { LabCase } from '../plan/LabPlan';
import { caseKey } from '../results/mergeRuns';
import type { Stage } from '../stage/Stage';
import { createStageFrames, type StageFrames } from './StageFrames';

/** Ending of a competitor's key that stands for another build of the Lab, served under `against/`. */
export const AGAINST = '@against';

/** A competitor in a case with which the browser crashed or hung. */
export interface Crash {
  readonly competitor: string;
  readonly labCase: LabCase;
}

/**
 * Iframes with the stage of this build; keys that end in {@link AGAINST} use those of the build under `against/`.
 *
 * @param crashes - cases in which a competitor is not opened again
 */
export function framesOfBuilds(
  parent: HTMLElement,
  crashes: readonly Crash[] = [],
  make: (parent: HTMLElement, url?: string) => StageFrames = createStageFrames,
): StageFrames {
  const current = make(parent);
  let other: StageFrames | null = null;
  let ownScene: Uint8Array | null = null;
  return {
    async stageOf(competitor) {
      if (!competitor.endsWith(AGAINST)) return watched(await current.stageOf(competitor), crashes);
      if (!other) {
        other = make(parent, './against/stage.html');
        if (ownScene) await other.setOwnScene(ownScene);
      }
      return watched(await other.stageOf(nameOf(competitor)), crashes);
    },
    async setOwnScene(file) {
      ownScene = file;
      await Promise.all([current.setOwnScene(file), other?.setOwnScene(file)]);
    },
    close() {
      current.close();
      other?.close();
    },
  };
}

/** Key of a competitor without {@link AGAINST}. */
export const nameOf = (competitor: string): string =>
  competitor.endsWith(AGAINST) ? competitor.slice(0, -AGAINST.length) : competitor;

/** Wraps a stage so that it refuses to open a competitor in a case where it crashed. Keys include {@link AGAINST}. */
function watched(stage: Stage, crashes: readonly Crash[]): Stage {
  return {
    async open(competitor, labCase, options) {
      const isSame = (crash: Crash): boolean =>
        crash.competitor === competitor && caseKey(crash.labCase) === caseKey(labCase);
      if (crashes.some(isSame)) throw new Error('Left out: the browser crashed or hung while it was measured.');
      return stage.open(nameOf(competitor), labCase, options);
    },
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
