import type { Camera } from 'three';
import type { Frame } from '../../frame/Frame';
import type { ChosenTechnique, SceneFigures, TechniqueChooser } from '../warm-up/TechniqueChooser';
import type { EffectsByTechnique } from '../TechniquePicker';
import type { TechniqueSet } from '../TechniqueSet';
import { GpuTimer } from '../timer';
import { WarmUp } from '../warm-up';
import { learnerOf } from './learners';
import type { TechniqueLearner } from './TechniqueLearner';

/** Minimum side of a picture (pixels): smaller ones are too fast to compare techniques. */
const SMALL = 64;
/** Number of consecutive frames in which another technique must be faster, as learnt, before a change. */
const PATIENCE = 30;
/** Number of frames after which a time query without a result is given up. */
const LOST = 120;
/** Tag of times that belong to no trial; those of a trial have its number × 4 + stage. */
const NONE = -1;

/**
 * Stages of a trial: one draw by the current technique, one by its rival, then one more, whose times show that the rival's are
 * complete.
 */
const [IDLE, FIRST, SECOND, LAST] = [0, 1, 2, 3];

type Chooser = TechniqueChooser<WarmUp>;

/** Learning state of one scene. */
class LearningScene {
  /** Technique that draws in place of the one that the rule picked; null for none. */
  substitute: ChosenTechnique | null = null;
  /** Number of draws in a row in which the learnt verdict was for another technique. */
  waited = 0;
  /** Technique whose programs are to be compiled, for a trial or a change; null for none. */
  next: ChosenTechnique | null = null;
  preparation: WarmUp | null = null;

  drop(): void {
    this.next = this.preparation = null;
  }
}

/**
 * Draws the trials that 'auto' learns from, and draws by learnt techniques. A trial is one draw by a technique whose programs
 * are ready, timed on GPU and CPU like the draw before it; the times are read some draws later, so that nothing waits.
 */
export class LearningFrames {
  /** Sentence on why the technique of this frame is not the rule's; null where it is. */
  reason: string | null = null;
  private readonly learner: TechniqueLearner;
  private readonly scenes = new WeakMap<Chooser, LearningScene>();
  private ownTimer: GpuTimer | null = null;
  private timer: GpuTimer | null = null;
  private stage = IDLE;
  private trial = 0;
  /** Chooser (one for each scene), camera, techniques and key of the trial under way. */
  private chooser: Chooser | null = null;
  private camera: Camera | null = null;
  private one: ChosenTechnique = 'clustered-deferred';
  private other: ChosenTechnique = 'clustered-deferred';
  private key = 0;
  /** GPU times (ms) of the draws FIRST and SECOND, by stage, and CPU times. */
  private readonly gpu = new Float64Array(3);
  private readonly cpu = new Float64Array(3);
  private started = 0;
  private waited = 0;
  /** Whether this draw is one of the trial. */
  private measures = false;

  constructor(
    private readonly frame: Frame,
    private readonly set: TechniqueSet,
  ) {
    this.learner = learnerOf(frame.gl);
  }

  /**
   * @param technique - technique that the rule picked
   * @param passTimer - timer that times the passes already; null for none
   * @param mayMeasure - whether trials may be drawn and timed; else only earlier verdicts are used
   * @returns the technique to draw this frame by
   */
  pick(
    chooser: Chooser,
    technique: ChosenTechnique,
    figures: SceneFigures,
    passTimer: GpuTimer | null,
    mayMeasure: boolean,
  ): ChosenTechnique {
    const { frame, learner } = this;
    this.reason = null;
    if (mayMeasure) this.follow(passTimer);
    else this.abandon();
    const { width, height } = frame;
    const rival =
      frame.view !== 'final' || Math.min(width, height) < SMALL
        ? null
        : learner.rivalOf(technique, chooser, figures, frame.hostSamples > 0);
    let scene = this.scenes.get(chooser);
    if (rival === null) {
      scene?.drop();
      if (scene !== undefined) scene.substitute = null;
      return technique;
    }
    if (scene === undefined) this.scenes.set(chooser, (scene = new LearningScene()));
    const key = learner.keyOf(technique, rival, figures);
    if (scene.substitute !== null && scene.substitute !== rival) scene.substitute = null;
    const present = scene.substitute ?? technique;
    const faster = learner.fasterOf(technique, rival, key);
    const isDue = mayMeasure && this.timer !== null && !chooser.isChanging && learner.isDue(key);
    const drawn = this.step(chooser, scene, present, present === rival ? technique : rival, key, isDue);
    if (drawn === present && this.stage === IDLE) this.change(scene, technique, present, faster);
    if (drawn !== present) this.reason = `measured against "${present}", to learn which is faster on this GPU`;
    else if (present === rival) this.reason = `learnt on this GPU: faster than "${technique}"`;
    if (this.measures) this.started = performance.now();
    return drawn;
  }

  /** Compiles the next technique of a scene, a little in each frame; call inside three's `render`, after all draws. */
  warmUp(chooser: Chooser, draws: EffectsByTechnique): void {
    const scene = this.scenes.get(chooser);
    if (scene === undefined || scene.next === null || scene.preparation?.ready) return;
    const { frame, set } = this;
    const { next } = scene;
    if (set.codeOf(next)?.ask() === false) return;
    const passes = set.passesOf(next);
    if (scene.preparation?.passes !== passes) scene.preparation = new WarmUp(frame, set.known[next], next, passes);
    scene.preparation.step(draws.effectsOf(next).all);
  }

  /** Ends a draw, also one that has failed. */
  end(): void {
    if (!this.measures) return;
    this.measures = false;
    if (this.timer === this.ownTimer) this.ownTimer!.end();
    if (this.stage < LAST) this.cpu[this.stage] = performance.now() - this.started;
  }

  dispose(): void {
    this.abandon();
    this.ownTimer?.dispose();
    if (this.timer?.onTime === this.addTime) this.timer.onTime = null;
    this.ownTimer = this.timer = null;
  }

  /** Reads the times that have arrived; the passes' own timer is read when the frame begins. */
  private follow(passTimer: GpuTimer | null): void {
    this.ownTimer ??= new GpuTimer(this.frame.gl);
    const timer = passTimer ?? this.ownTimer;
    if (timer !== this.timer) this.abandon();
    this.timer = timer.available ? timer : null;
    if (this.stage === IDLE) return;
    if (timer === this.ownTimer) timer.poll();
    timer.tag = NONE;
    if (++this.waited > LOST) this.abandon();
  }

  /** Continues a trial, or begins one. @returns the technique to draw by */
  private step(
    chooser: Chooser,
    scene: LearningScene,
    present: ChosenTechnique,
    rival: ChosenTechnique,
    key: number,
    isDue: boolean,
  ): ChosenTechnique {
    if (this.stage === IDLE) {
      if (!isDue) {
        if (scene.waited < PATIENCE) scene.drop();
        return present;
      }
      if (scene.next !== rival) scene.drop();
      scene.next = rival;
      if (scene.preparation?.ready !== true) return present;
      this.trial++;
      this.chooser = chooser;
      this.camera = this.frame.seenBy;
      this.one = present;
      this.other = rival;
      this.key = key;
      this.gpu.fill(0);
    } else if (this.stage === LAST || this.chooser !== chooser || this.camera !== this.frame.seenBy) return present;
    else if (key !== this.key || present !== this.one) {
      this.abandon();
      return present;
    }
    this.stage++;
    this.measure();
    if (this.stage !== SECOND) return present;
    this.learner.begin();
    // drops what was prepared: objects that were added since need further programs
    scene.drop();
    return rival;
  }

  /** Starts timing this draw. */
  private measure(): void {
    const timer = this.timer!;
    this.measures = true;
    timer.tag = this.trial * 4 + this.stage;
    timer.onTime = this.addTime;
    if (timer === this.ownTimer) timer.begin('learning');
  }

  /** Changes to the technique learnt to be faster, once it has been so for some draws and its programs are ready. */
  private change(
    scene: LearningScene,
    technique: ChosenTechnique,
    present: ChosenTechnique,
    faster: ChosenTechnique,
  ): void {
    scene.waited = faster === present ? 0 : scene.waited + 1;
    if (scene.waited < PATIENCE) return;
    if (scene.next !== faster) scene.drop();
    scene.next = faster;
    if (scene.preparation?.ready !== true) return;
    scene.drop();
    scene.waited = 0;
    scene.substitute = faster === technique ? null : faster;
  }

  private abandon(): void {
    this.stage = IDLE;
    this.chooser = this.camera = null;
    this.waited = 0;
  }

  private readonly addTime = (tag: number, ms: number): void => {
    if (this.stage === IDLE || Math.floor(tag / 4) !== this.trial) return;
    const stage = tag % 4;
    if (stage < LAST) this.gpu[stage] += ms;
    else this.finish();
  };

  /** Learns from a trial. The time of a draw is the longer one of GPU and CPU. */
  private finish(): void {
    const { gpu, cpu, key, one, other } = this;
    this.abandon();
    if (!(gpu[FIRST] > 0 && gpu[SECOND] > 0)) return;
    this.learner.add(key, one, Math.max(gpu[FIRST], cpu[FIRST]), other, Math.max(gpu[SECOND], cpu[SECOND]));
  }
}
