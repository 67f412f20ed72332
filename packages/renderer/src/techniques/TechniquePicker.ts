import type { WebGLRenderer } from 'three';
import { checkDevice, hasFloatTargets } from '../checkDevice';
import type { FarolEffect } from '../FarolEffect';
import type { Frame } from '../Frame';
import { rehearsalCode } from '../late';
import type { LightTable } from '../lights/LightTable';
import type { Rehearsal } from '../rehearsal/Rehearsal';
import type { TechniqueName } from '.';
import type { TechniqueChooser } from './TechniqueChooser';
import type { TechniqueSet } from './TechniqueSet';

/** Picks what draws each frame of a renderer, and has what 'auto' is to draw by next made ready. */
export class TechniquePicker {
  /** What draws this frame: the technique asked for, or what 'auto' picked. */
  active: TechniqueName = 'deferred';
  /** Why that one. */
  reason = '';
  private asked: TechniqueName = 'auto';
  private readonly floatTargets: boolean;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly set: TechniqueSet,
  ) {
    this.floatTargets = hasFloatTargets(webgl);
  }

  /** What is asked for. @throws Error when unknown, or the device cannot run it */
  get technique(): TechniqueName {
    return this.asked;
  }

  set technique(name: TechniqueName) {
    checkDevice(this.webgl, this.set.get(name).needsFloatTargets);
    this.asked = name;
  }

  /**
   * Sets `active` and `reason`; to be called when the lights of the frame are collected.
   * @param chooser of the scene that is drawn
   */
  pick(chooser: TechniqueChooser<Rehearsal>, frame: Frame, table: LightTable, effects: readonly FarolEffect[]): void {
    this.active = this.asked;
    this.reason = 'asked for';
    const { late } = this.set.known[this.active];
    if (late?.code === null) {
      late.ask();
      this.active = 'deferred';
      this.reason = `the code of "${this.asked}" is being fetched`;
    }
    if (this.asked === 'auto') this.choose(chooser, frame, table, effects);
    const { elements } = frame.camera.projectionMatrix;
    // a mirror's camera, whose near plane is the mirror
    const isOblique = elements[2] !== 0 || elements[6] !== 0;
    if (isOblique && this.set.known[this.active].rebuildsPositions) {
      this.active = 'clustered-forward';
      this.reason = "the camera's near plane is oblique";
    }
  }

  private choose(
    chooser: TechniqueChooser<Rehearsal>,
    frame: Frame,
    { bounded, coverage, directional, unbounded }: LightTable,
    effects: readonly FarolEffect[],
  ): void {
    let surfaces = false;
    for (const effect of effects) surfaces ||= effect.needsSurfaces === true;
    const choice = chooser.choose(
      {
        bounded,
        coverage,
        everywhere: directional + unbounded,
        transparents: frame.queue.hasLitTransparents,
        floatTargets: this.floatTargets,
        surfaces,
      },
      rehearsalCode.code !== null,
    );
    if (chooser.settled) rehearsalCode.ask();
    this.active = choice.technique;
    this.reason = surfaces ? 'an effect works on its G-buffer' : choice.reason;
  }

  /** Has what 'auto' is to draw by next made ready, a little in each frame; to be called when the frame is drawn. */
  rehearse(chooser: TechniqueChooser<Rehearsal>, frame: Frame, effects: readonly FarolEffect[]): void {
    if (chooser.next === null || this.asked !== 'auto') return;
    const { technique } = chooser.next;
    const { known } = this.set;
    chooser.preparation ??= new rehearsalCode.code!.Rehearsal(frame, known[technique], this.set.passesOf(technique));
    chooser.preparation.step(effects);
  }
}
