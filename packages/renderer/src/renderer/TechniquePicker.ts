import type { WebGLRenderer } from 'three';
import { checkDevice, lacksFloatTargets } from '../gpu/checkDevice';
import type { ActiveEffects } from '../frame/ActiveEffects';
import type { Frame } from '../frame/Frame';
import type { Pass } from '../frame/Pass';
import { learningCode, warmUpCode } from './lazyCode';
import type { LearningFrames } from './learning';
import type { LightTable } from '../lighting/LightTable';
import type { WarmUp } from './warm-up/WarmUp';
import type { TechniqueName } from '../techniques';
import { MOST_IN_A_LOOP, type TechniqueChooser } from './TechniqueChooser';
import type { TechniqueSet } from './TechniqueSet';
import type { GpuTimer } from './timer/GpuTimer';

/** Up to this many lights 'forward-single-pass' begins to draw a scene until another technique's code is loaded. */
const FEW = 16;

/** Gives the effects of a frame, by the technique that draws it. */
export interface EffectsByTechnique {
  effectsOf(technique: string): ActiveEffects;
}

/** Picks the technique of each frame of a renderer, and prepares the next one of 'auto'. */
export class TechniquePicker {
  /** Technique that draws this frame: the one asked for, or the one that 'auto' picked. */
  active: TechniqueName = 'deferred';
  /** Sentence that tells why `active` was chosen. */
  reason = '';
  /** Whether 'auto' may change to another technique soon. */
  isChanging = false;
  /** Whether 'auto' learns, as `FarolOptions.learning`. */
  learns = false;
  /** Whether trials may be drawn and timed in this frame. */
  mayMeasure = false;
  /** Times the passes of this frame; null if nothing does. */
  passTimer: GpuTimer | null = null;
  /** Trials of 'auto'; null until there is something to learn and the code is there. */
  learning: LearningFrames | null = null;
  private asked: TechniqueName = 'auto';

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly set: TechniqueSet,
  ) {}

  /** Technique asked for. @throws Error when unknown, or the device cannot run it */
  get technique(): TechniqueName {
    return this.asked;
  }

  set technique(name: TechniqueName) {
    checkDevice(this.webgl, this.set.get(name).needsFloatTargets);
    this.asked = name;
    this.set.codeOf(name)?.ask();
  }

  /**
   * Sets `active` and `reason`. Call when the lights of the frame are collected.
   * @param chooser - chooser of the scene that is drawn
   */
  pick(chooser: TechniqueChooser<WarmUp>, frame: Frame, table: LightTable, effects: ActiveEffects): void {
    this.find(chooser, frame, table, effects);
    chooser.drawn = this.active;
  }

  private find(
    chooser: TechniqueChooser<WarmUp>,
    frame: Frame,
    table: LightTable,
    { needsSurfaces }: ActiveEffects,
  ): void {
    this.active = this.asked;
    this.reason = 'asked for';
    this.isChanging = false;
    if (!frame.hasPlainProjection) {
      this.active = 'forward-single-pass';
      this.reason = 'the projection is skewed';
      return;
    }
    const lights = table.bounded + table.directional + table.unbounded + (frame.fields?.count ?? 0);
    const floatTargets = lacksFloatTargets(this.webgl) === null;
    if (this.asked === 'auto') {
      if (frame.session === null) this.choose(chooser, frame, table, needsSurfaces, floatTargets);
      else {
        this.active = needsSurfaces && floatTargets ? 'clustered-deferred' : 'clustered-forward';
        this.reason = 'an XR session: pictures are multisampled';
      }
    }
    const { active } = this;
    if (this.set.codeOf(active)?.ask() !== false) return;
    const { drawn } = chooser;
    const single = !floatTargets || (lights <= FEW && !this.set.known[active].needsFloatTargets);
    this.active =
      drawn !== null && this.canGoOn(drawn, lights, floatTargets, needsSurfaces)
        ? drawn
        : single
          ? 'forward-single-pass'
          : 'deferred';
    this.reason = `the code of "${active}" is being fetched`;
  }

  /** Whether a technique that has drawn the scene, and so has its programs, can draw this frame too. */
  private canGoOn(technique: TechniqueName, lights: number, floatTargets: boolean, surfaces: boolean): boolean {
    const { set } = this;
    if (!Object.hasOwn(set.known, technique) || set.codeOf(technique)?.isThere === false) return false;
    if (technique === 'forward-single-pass' && lights > MOST_IN_A_LOOP) return false;
    if (set.known[technique].needsFloatTargets && !floatTargets) return false;
    return !surfaces || set.passesOf(technique).some(writesGBuffer);
  }

  /** Sets the technique that 'auto' draws by. */
  private choose(
    chooser: TechniqueChooser<WarmUp>,
    frame: Frame,
    { bounded, coverage, directional, unbounded }: LightTable,
    surfaces: boolean,
    floatTargets: boolean,
  ): void {
    const figures = {
      bounded: bounded + (frame.fields?.count ?? 0),
      coverage: coverage + (frame.fields?.coverage ?? 0),
      everywhere: directional + unbounded,
      objects: frame.queue.opaque.length,
      transparents: frame.queue.hasLitTransparents,
      floatTargets,
      surfaces,
      pixels: frame.width * frame.height,
      multisampled: frame.hostSamples > 0,
      overdraw: chooser.overdraw?.layers ?? 0,
      triangles: chooser.overdraw?.triangles ?? 0,
    };
    const choice = chooser.choose(figures, warmUpCode.isThere);
    if (chooser.settled) warmUpCode.ask();
    this.isChanging = chooser.isChanging;
    this.active = choice.technique;
    this.reason = surfaces ? 'an effect works on its G-buffer' : choice.reason;
    if (!this.learns || !chooser.settled) return;
    this.learning ??= learningCode.use((code) => new code.LearningFrames(frame, this.set));
    const { learning } = this;
    if (learning === null) return;
    this.active = learning.pick(chooser, choice.technique, figures, this.passTimer, this.mayMeasure);
    this.reason = learning.reason ?? this.reason;
  }

  /** Prepares the next technique of 'auto', a little in each frame; call it when the frame is drawn. */
  warmUp(chooser: TechniqueChooser<WarmUp>, frame: Frame, draws: EffectsByTechnique): void {
    if ((chooser.settled || this.asked !== 'auto' || frame.session !== null) && warmUpCode.isThere) {
      chooser.overdraw ??= new warmUpCode.required.Overdraw();
      chooser.overdraw.follow(frame);
    }
    if (this.asked !== 'auto') return;
    if (chooser.next === null) {
      if (this.learns) this.learning?.warmUp(chooser, draws);
      return;
    }
    const { technique } = chooser.next;
    const { known } = this.set;
    if (this.set.codeOf(technique)?.ask() === false) return;
    const passes = this.set.passesOf(technique);
    // after a lost context the technique has other passes
    if (chooser.preparation?.passes !== passes)
      chooser.preparation = warmUpCode.use(({ WarmUp }) => new WarmUp(frame, known[technique], technique, passes));
    chooser.preparation?.step(draws.effectsOf(technique).all);
  }
}

const writesGBuffer = ({ writes }: Pass): boolean => writes.includes('gbuffer');
