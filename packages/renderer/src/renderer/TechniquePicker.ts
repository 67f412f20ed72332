import type { WebGLRenderer } from 'three';
import { checkDevice, lacksFloatTargets } from '../gpu/checkDevice';
import type { ActiveEffects } from '../frame/ActiveEffects';
import type { Frame } from '../frame/Frame';
import type { Pass } from '../frame/Pass';
import type { TechniqueChooser } from './warm-up/TechniqueChooser';
import { learningCode, warmUpCode } from './lazyCode';
import type { LearningFrames } from './learning';
import type { LightTable } from '../lighting/LightTable';
import type { Overdraw } from './warm-up/Overdraw';
import type { WarmUp } from './warm-up/WarmUp';
import type { TechniqueName } from '../techniques';
import { MOST_IN_A_LOOP, type TechniqueSet } from './TechniqueSet';
import type { GpuTimer } from './timer/GpuTimer';

/** Up to this many lights, 'forward-single-pass' draws a scene until another technique's code is loaded. */
const FEW = 16;

/** Per-scene state of 'auto', kept from frame to frame. */
export interface DrawnScene {
  /** Picks the scene's technique for 'auto'; null until 'auto' is used and its code is loaded. */
  chooser: TechniqueChooser<WarmUp> | null;
  /** Technique that drew the scene's last frame; null before the first frame. */
  drawn: TechniqueName | null;
  /** Estimate of the scene's overdraw; null until its code is loaded. */
  overdraw: Overdraw | null;
}

/** Source of a frame's effects, which depend on its technique. */
export interface EffectsByTechnique {
  effectsOf(technique: string): ActiveEffects;
}

/** Picks the technique of each frame of a renderer, and prepares the next one of 'auto'. */
export class TechniquePicker {
  /** Technique that draws this frame: the host's choice, or the one that 'auto' picked. */
  active: TechniqueName = 'deferred';
  /** Sentence on why `active` was chosen. */
  reason = '';
  /** Whether 'auto' may change to another technique soon. */
  isChanging = false;
  /** Whether 'auto' learns, as `FarolOptions.learning`. */
  learns = false;
  /** Whether trials may be drawn and timed in this frame. */
  mayMeasure = false;
  /** GPU timer of this frame's passes; null if they are not timed. */
  passTimer: GpuTimer | null = null;
  /** Trials of 'auto'; null until there is something to learn and their code is loaded. */
  learning: LearningFrames | null = null;
  private requested: TechniqueName = 'auto';

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly set: TechniqueSet,
  ) {}

  /** Technique of `FarolOptions.technique`. @throws Error when set to an unknown one, or one that the device cannot run */
  get technique(): TechniqueName {
    return this.requested;
  }

  set technique(name: TechniqueName) {
    checkDevice(this.webgl, this.set.get(name).needsFloatTargets);
    this.requested = name;
    this.set.codeOf(name)?.ask();
  }

  /** Sets `active` and `reason`. Call when the lights of the frame are collected. */
  pick(scene: DrawnScene, frame: Frame, table: LightTable, effects: ActiveEffects): void {
    this.find(scene, frame, table, effects);
    scene.drawn = this.active;
  }

  private find(scene: DrawnScene, frame: Frame, table: LightTable, { needsSurfaces }: ActiveEffects): void {
    this.active = this.requested;
    this.reason = 'asked for';
    this.isChanging = false;
    if (!frame.hasPlainProjection) {
      this.active = 'forward-single-pass';
      this.reason = 'the projection is skewed';
      return;
    }
    const lights = table.bounded + table.directional + table.unbounded + (frame.fields?.count ?? 0);
    const floatTargets = lacksFloatTargets(this.webgl) === null;
    if (this.requested === 'auto') {
      if (frame.session === null) this.choose(scene, frame, table, needsSurfaces, floatTargets);
      else {
        this.active = needsSurfaces && floatTargets ? 'clustered-deferred' : 'clustered-forward';
        this.reason = 'an XR session: pictures are multisampled';
      }
    }
    const { active } = this;
    if (active !== 'auto' && this.set.codeOf(active)?.ask() !== false) return;
    const { drawn } = scene;
    const deferred = active === 'auto' ? needsSurfaces : this.set.known[active].needsFloatTargets;
    const single = !floatTargets || (lights <= FEW && !deferred);
    this.active =
      drawn !== null && this.canGoOn(drawn, lights, floatTargets, needsSurfaces)
        ? drawn
        : single
          ? 'forward-single-pass'
          : 'deferred';
    this.reason = `the code of "${active}" is being fetched`;
  }

  /** Whether a technique that drew the scene before, so that its programs exist, can draw this frame too. */
  private canGoOn(technique: TechniqueName, lights: number, floatTargets: boolean, surfaces: boolean): boolean {
    const { set } = this;
    if (!Object.hasOwn(set.known, technique) || set.codeOf(technique)?.isThere === false) return false;
    if (technique === 'forward-single-pass' && lights > MOST_IN_A_LOOP) return false;
    if (set.known[technique].needsFloatTargets && !floatTargets) return false;
    return !surfaces || set.passesOf(technique).some(writesGBuffer);
  }

  /** Sets `active` to the choice of 'auto'; `active` remains 'auto' until the code of its rules is loaded. */
  private choose(scene: DrawnScene, frame: Frame, table: LightTable, surfaces: boolean, floatTargets: boolean): void {
    const chooser = (scene.chooser ??= warmUpCode.use((code) => new code.TechniqueChooser<WarmUp>()));
    if (chooser === null) return;
    const figures = warmUpCode.required.figuresOf(frame, table, scene.overdraw, surfaces, floatTargets);
    const choice = chooser.choose(figures);
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

  /** Compiles the next technique of 'auto', a little in each frame; call it at the end of a frame. */
  warmUp(scene: DrawnScene, frame: Frame, draws: EffectsByTechnique): void {
    const { chooser } = scene;
    frame.preparation?.step([]);
    const waits = this.requested === 'auto' && frame.session === null && chooser?.settled !== true;
    if (!waits && warmUpCode.isThere) {
      const { Overdraw, strictDraw } = warmUpCode.required;
      scene.overdraw ??= new Overdraw(strictDraw(this.webgl));
      scene.overdraw.follow(frame);
    }
    if (this.requested !== 'auto' || chooser === null) return;
    if (chooser.next === null) {
      if (this.learns) this.learning?.warmUp(chooser, draws);
      return;
    }
    const { technique } = chooser.next;
    const { known } = this.set;
    if (this.set.codeOf(technique)?.ask() === false) return;
    const passes = this.set.passesOf(technique);
    // after a lost context the passes of the technique are new objects
    if (chooser.preparation?.passes !== passes)
      chooser.preparation = new warmUpCode.required.WarmUp(frame, known[technique], technique, passes);
    chooser.preparation.step(draws.effectsOf(technique).all);
  }
}

const writesGBuffer = ({ writes }: Pass): boolean => writes.includes('gbuffer');
