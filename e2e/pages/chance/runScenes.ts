import type { TechniqueName } from '@farol/renderer';
import type { Difference } from '../../support/images';
import { chooseScene, DECK } from './chooseScene';
import { compareScene, compared, forgetScenes, type SceneResult } from './compareScene';
import { kindOf, namesOf } from './kindOf';
import { leaveOut } from './leftOut';
import type { SceneFacts } from './SceneFacts';
import { runChanges } from './runChanges';
import { shrink } from './shrink';

/** A scene that a technique draws otherwise than stock three. */
export interface ChanceFault {
  readonly seed: number;
  readonly techniques: readonly TechniqueName[];
  /** Fault of the first of `techniques`: figures, or what was thrown or said. */
  readonly fault: string;
  /** Part of the scene that is enough for the fault; all of it where it was not shrunk. */
  readonly facts: SceneFacts;
  /** Names of what is left; null where the scene was not shrunk. */
  readonly kind: string | null;
  /** Whether the scene fails only after those before it. */
  readonly isLeftOver: boolean;
}

export interface ScenePicture extends Difference {
  readonly seed: number;
  readonly technique: TechniqueName;
  readonly good: boolean;
}

export interface ChanceResult {
  readonly pictures: ScenePicture[];
  readonly faults: ChanceFault[];
  /** Seeds of scenes that say nothing, and why. */
  readonly unseen: { readonly seed: number; readonly why: string }[];
}

export interface ChanceOptions {
  /** Default all but `inferred`. */
  readonly techniques?: readonly TechniqueName[];
  /** Scenes that are shrunk, at most; default all. */
  readonly shrinks?: number;
  /** Pictures by a technique that a scene is shrunk with, at most; default 120. */
  readonly tries?: number;
}

/** A scene by one technique; null where it says nothing. */
function drawBy(facts: SceneFacts, technique: TechniqueName): SceneResult | null {
  const results = compareScene(facts, [technique]);
  return 'unseen' in results ? null : (results[0] ?? null);
}

/** Whether a part of a scene has the fault of all of it: as many words said, or about as far off. */
function isAlike(part: SceneResult | null, whole: SceneResult): boolean {
  if (part === null || part.fault === null) return false;
  if (whole.isSaid || part.isSaid) return whole.isSaid && part.isSaid;
  const { psnr, share } = part.difference;
  return psnr < whole.difference.psnr + 6 || share > whole.difference.share / 2;
}

/** Shrinks failing scenes, except those that hold all names of a scene of the same deck that was shrunk before. */
class Shrinker {
  private readonly found: { techniques: string; names: Set<string>; kind: string }[] = [];

  constructor(
    private left: number,
    private readonly tries: number,
  ) {}

  shrink(
    facts: SceneFacts,
    techniques: readonly TechniqueName[],
    whole: SceneResult,
  ): Pick<ChanceFault, 'facts' | 'kind'> {
    const all = namesOf(facts);
    const key = techniques.join();
    const same = this.found.find((one) => one.techniques === key && [...one.names].every((name) => all.has(name)));
    if (same) return { facts, kind: same.kind };
    if (this.left-- <= 0) return { facts, kind: null };
    const least = shrink(facts, (tried) => isAlike(drawBy(tried, techniques[0]), whole), this.tries);
    const kind = kindOf(least);
    this.found.push({ techniques: key, names: namesOf(least), kind });
    return { facts: least, kind };
  }
}

/**
 * Draws the scenes of seeds by stock three and by every technique, and shrinks those that differ.
 *
 * @param seeds - of one deck, in order: see {@link DECK}
 */
export function runScenes(seeds: readonly number[], options: ChanceOptions = {}): ChanceResult {
  const { techniques = compared, shrinks = Infinity, tries = 120 } = options;
  const result: ChanceResult = { pictures: [], faults: [], unseen: [] };
  const shrinker = new Shrinker(shrinks, tries);
  for (const seed of seeds) {
    const facts = leaveOut(chooseScene(seed));
    const results = compareScene(facts, techniques);
    if ('unseen' in results) {
      result.unseen.push({ seed, why: results.unseen });
      continue;
    }
    for (const { technique, difference, fault } of results)
      result.pictures.push({ seed, technique, good: fault === null, ...difference });
    const off = results.filter(({ fault }) => fault !== null);
    if (off.length === 0) continue;
    const names = off.map(({ technique }) => technique);
    const again = drawBy(facts, names[0]);
    const isLeftOver = again === null || again.fault === null;
    const least = isLeftOver ? { facts, kind: null } : shrinker.shrink(facts, names, again);
    result.faults.push({ seed, techniques: names, fault: off[0].fault!, ...least, isLeftOver });
  }
  forgetScenes();
  return result;
}

export { chooseScene, compared, compareScene, DECK, forgetScenes, runChanges };
