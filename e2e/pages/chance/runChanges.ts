import type { TechniqueName } from '@farol/renderer';
import { compareImages, figuresOf } from '../../support/images';
import { Bench } from '../Bench';
import { ChangingScene } from './ChangingScene';
import { changes } from './changes';
import { compared, listen, readCanvas } from './compareScene';
import { Dice } from './Dice';
import { shrink } from './shrink';

const WIDTH = 96;
const HEIGHT = 64;
/** Signal to noise, at least (dB), and share of pixels off by more than 2/255, at most. */
const PSNR = 50;
const SHARE = 0.004;

export interface ChangesOptions {
  /** Frames of a seed; default 20. */
  readonly steps?: number;
  readonly techniques?: readonly TechniqueName[];
  /** Techniques that draw a frame; default 3. */
  readonly perStep?: number;
  readonly depth?: 'logarithmic' | 'reversed';
  /** Whether the context is lost between some frames. */
  readonly losesContext?: boolean;
  /** Frames drawn anew to cut a fault down, at most; default 60. */
  readonly tries?: number;
  /** Names of changes that are left out. */
  readonly without?: readonly string[];
}

/** A frame that a technique draws otherwise than stock three. */
export interface ChangesFault {
  readonly seed: number;
  readonly step: number;
  readonly technique: TechniqueName;
  readonly fault: string;
  /** Changes that are enough for it, as frame and name. */
  readonly changes: readonly string[];
  /** Whether the fault shows only where the frames before its own are drawn too. */
  readonly isLeftOver: boolean;
}

export interface ChangesResult {
  compared: number;
  /** Frames that stock three does not draw alike twice, and faults that are gone when all is drawn again. */
  unsure: number;
  readonly faults: ChangesFault[];
}

/** A change of a frame, as frame, name and a seed of its own: others may be left out. */
type Step = `${number} ${string} ${number}`;
const stepOf = (step: Step) => Number(step.split(' ', 1)[0]);

function stepsOf(seed: number, count: number, without: readonly string[]): Step[] {
  const names = Object.keys(changes).filter((name) => !without.includes(name));
  return Array.from({ length: count }, (_, step) => {
    const dice = new Dice(seed * 1009 + step);
    const length = dice.whole(1, 4);
    return Array.from({ length }, (): Step => `${step} ${dice.of(names)} ${dice.whole(0, 1e6)}`);
  }).flat();
}

/** A changing scene and who draws it. */
class Stage {
  readonly bench: Bench;
  readonly world: ChangingScene;

  constructor(seed: number, { depth, losesContext }: ChangesOptions) {
    const parameters = depth && { [`${depth}DepthBuffer`]: true };
    const renderer = { ...parameters, preserveDrawingBuffer: true };
    this.bench = new Bench(WIDTH, HEIGHT, { renderer, losesContext });
    const { webgl, farol } = this.bench;
    webgl.shadowMap.enabled = true;
    webgl.localClippingEnabled = true;
    farol.inferredScale = 1;
    this.world = new ChangingScene(this.bench, seed);
  }

  apply(step: Step): void {
    const [, name, seed] = step.split(' ');
    changes[name](this.world, new Dice(Number(seed)));
  }

  /** @param technique - null: stock three */
  draw(technique: TechniqueName | null, toCanvas: boolean) {
    const { webgl, farol } = this.bench;
    const { scene, camera, second } = this.world;
    const asked = this.world.allLights.map(({ shadow }) => shadow.needsUpdate);
    if (technique !== null) farol.technique = technique;
    const by = technique === null ? webgl : farol;
    const draw = () => {
      webgl.clear();
      if (second) by.render(second, camera);
      by.render(scene, camera);
    };
    const result = listen(() => {
      if (!toCanvas) return this.bench.draw(draw);
      webgl.setRenderTarget(null);
      draw();
      return readCanvas(webgl);
    });
    webgl.setRenderTarget(null);
    this.world.allLights.forEach(({ shadow }, i) => (shadow.needsUpdate = asked[i]));
    return result;
  }

  /** A frame of the techniques against stock three's. */
  compare(dice: Dice, techniques: readonly TechniqueName[]) {
    const toCanvas = dice.in(0.25);
    const farolFirst = dice.in(0.5);
    if (farolFirst) this.draw(techniques[0], toCanvas);
    const stock = this.draw(null, toCanvas);
    const drawn = techniques.map((technique) => ({ technique, ...this.draw(technique, toCanvas) }));
    const again = this.draw(null, toCanvas);
    for (const { shadow } of this.world.allLights) shadow.needsUpdate = false;
    if (!stock.result || !again.result) return null;
    const steady = compareImages(stock.result, again.result);
    if (steady.largest > 1e-4 && steady.largest !== Infinity) return null;
    return drawn.map(({ technique, result, said }) => {
      const words = said.filter((text) => !stock.said.includes(text));
      if (words.length > 0 || result === null) return { technique, fault: words.join('; ') || 'nothing' };
      const difference = compareImages(stock.result!, result);
      const isGood =
        difference.psnr >= PSNR && difference.share <= SHARE && difference.alpha <= (toCanvas ? 0.005 : 1e-3);
      return { technique, fault: isGood ? null : figuresOf(difference) + (toCanvas ? ', canvas' : '') };
    });
  }

  free(): void {
    this.world.dispose();
    this.bench.free();
  }
}

const diceOf = (seed: number, step: number) => new Dice(seed * 7919 + step * 31 + 5);

/** Techniques that draw a frame. */
function techniquesOf(seed: number, step: number, { techniques = compared, perStep = 3 }: ChangesOptions) {
  const turn = (seed * 3 + step) * perStep;
  return Array.from({ length: perStep }, (_, i) => techniques[(turn + i) % techniques.length]);
}

/** Whether a frame has a fault by a technique after some of the changes. @param between - frames before it are drawn too */
function fails(
  seed: number,
  steps: readonly Step[],
  technique: TechniqueName,
  last: number,
  between: boolean,
  options: ChangesOptions,
): boolean {
  const stage = new Stage(seed, { ...options, losesContext: false });
  try {
    for (let step = 0; step <= last; step++) {
      const own = steps.filter((one) => stepOf(one) === step);
      for (const one of own) stage.apply(one);
      if (step < last && !between) continue;
      const found = stage.compare(diceOf(seed, step), techniquesOf(seed, step, options));
      if (step === last) return found?.some((one) => one.technique === technique && one.fault !== null) ?? false;
    }
    return false;
  } catch {
    return false;
  } finally {
    stage.free();
  }
}

/** Draws scenes that change by chance, by stock three and by techniques in turn; ends a seed with its first fault. */
export async function runChanges(seeds: readonly number[], options: ChangesOptions = {}): Promise<ChangesResult> {
  const { steps: count = 20, losesContext = false, tries = 60, without = [] } = options;
  const result: ChangesResult = { compared: 0, unsure: 0, faults: [] };
  for (const seed of seeds) {
    const steps = stepsOf(seed, count, without);
    let failed: Omit<ChangesFault, 'changes' | 'isLeftOver'> | null = null;
    const stage = new Stage(seed, options);
    for (let step = 0; step < count && failed === null; step++) {
      for (const one of steps) if (stepOf(one) === step) stage.apply(one);
      const dice = diceOf(seed, step);
      if (losesContext && step % 5 === 4) await stage.bench.loseContext();
      const found = stage.compare(dice, techniquesOf(seed, step, options));
      if (found === null) result.unsure++;
      else result.compared += found.length;
      const off = found?.find(({ fault }) => fault !== null);
      if (off) failed = { seed, step, technique: off.technique, fault: off.fault! };
      await new Promise((resolve) => setTimeout(resolve));
    }
    stage.free();
    if (failed === null) continue;
    const { step, technique } = failed;
    const known = steps.filter((one) => stepOf(one) <= step);
    const isLeftOver = !fails(seed, known, technique, step, false, options);
    // rasterisers draw some lines and batches by chance
    if (isLeftOver && !fails(seed, known, technique, step, true, options)) {
      result.unsure++;
      continue;
    }
    const isOff = ({ kept = [] }: { kept?: readonly Step[] }) =>
      fails(seed, kept, technique, step, isLeftOver, options);
    const { kept } = shrink({ kept: known }, isOff, tries);
    result.faults.push({ ...failed, isLeftOver, changes: kept });
  }
  return result;
}
