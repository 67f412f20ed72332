import type { Material, Mesh, Object3D } from 'three';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import { ResourceTable } from '../../frame/Resources';
import type { Pass } from '../../frame/Pass';
import type { RenderItem } from '../../frame/RenderItem';
import type { Fills } from '../../frame/Fills';
import type { Preparation } from './TechniqueChooser';
import {
  programsOf,
  stopUsingPrograms,
  waitingPrograms,
  watchNewPrograms,
  type ProgramList,
  type WaitingPrograms,
} from '../../three/WaitingPrograms';

/** Maximum number of draws tried in one frame: some tenths of a millisecond. */
const DRAWS = 128;
const STOP = new Error('Farol: warmed up');
const stop = (): never => {
  throw STOP;
};

/**
 * Compiles a technique's programs for the current scene while another technique draws it. At the end of a frame its passes run
 * with all targets bound as they would be, but each draw ends once three has started to compile and link its program: nothing is
 * drawn, cleared or waited for, and only those callbacks of the host run that a compilation calls. Each frame starts one new
 * program at most; then each sets the uniforms of one linked program, so that no frame is long.
 */
export class WarmUp implements Preparation {
  /** True when all programs that the technique needs for the scene, as of the last `step`, are linked. */
  ready = false;
  private readonly dry: Frame;
  /** Geometries tried for each material; objects instead where the shader depends on the object too. */
  private readonly triedGeometries = new Map<Material, Set<object>>();
  private programs: ProgramList | null = null;
  private waiting!: WaitingPrograms;
  /** Number of draws that may still be tried in this frame. */
  private left = 0;
  /** Whether a draw was left for a later frame. */
  private cut = true;

  constructor(
    private readonly frame: Frame,
    private readonly technique: { readonly fills?: Fills | null },
    private readonly name: string,
    readonly passes: readonly Pass[],
  ) {
    this.dry = Object.assign(Object.create(frame) as Frame, {
      resources: new ResourceTable(),
      clear() {},
      resolve() {},
      copyDepth() {},
      drawNodes() {},
      drawItem: (item: RenderItem, material: Material) => {
        // a material that needs no twin has just been drawn
        if (material !== item.material) this.tryDraw(item.object, item, material, item.materialVariant > 0);
      },
      drawMesh: (mesh: Mesh, material: Material) =>
        this.tryDraw(mesh, { geometry: mesh.geometry, group: null }, material),
      // passes compile a mesh only once, so it is tried even if `left` is 0
      compileMesh: (mesh: Mesh, material: Material) => {
        const { left } = this;
        this.left = 1;
        this.tryDraw(mesh, { geometry: mesh.geometry, group: null }, material);
        this.left = Math.min(left, this.left);
      },
    });
  }

  /** Compiles a little more. Call inside three's `render`, after all draws; may leave another target bound. */
  step(effects: readonly FarolEffect[]): void {
    const programs = programsOf(this.frame.webgl);
    if (programs !== this.programs) {
      // after a lost context three has a new list of programs
      this.programs = programs;
      this.waiting = waitingPrograms(programs);
      this.triedGeometries.clear();
      this.cut = true;
    }
    this.waiting.finishOne();
    if (this.cut) this.run(effects);
    this.ready = !this.cut && this.waiting.length === 0;
  }

  private run(effects: readonly FarolEffect[]): void {
    const { frame, dry, waiting, programs } = this;
    const { fills = 'behind' } = this.technique;
    const { queue } = frame;
    for (let i = queue.early; i < queue.opaque.length; i++) queue.opaque[i].drawn = false;
    // the dry run fills the pixels that this technique, when it draws, fills
    dry.fills = fills;
    dry.resources.begin();
    this.left = DRAWS;
    this.cut = false;
    const resume = stopUsingPrograms(frame.webgl, stop);
    waiting.block(stop);
    const unwatch = watchNewPrograms(programs!, (program) => {
      this.left = 0;
      waiting.add(program, stop);
    });
    try {
      for (const pass of this.passes) {
        if (this.cut) break;
        if (effects.some(({ replaces }) => replaces !== undefined && pass.writes.includes(replaces))) continue;
        dry.resources.use(this.name, pass);
        if (pass.warmUp !== undefined) pass.warmUp(dry);
        else pass.render(dry);
      }
      for (const effect of effects) effect.warmUp?.(dry);
    } finally {
      unwatch();
      waiting.unblock();
      resume();
    }
  }

  private tryDraw(
    object: Object3D,
    { geometry, group }: Pick<RenderItem, 'geometry' | 'group'>,
    material: Material,
    byObject = false,
  ): void {
    let seen = this.triedGeometries.get(material);
    if (seen === undefined) this.triedGeometries.set(material, (seen = new Set()));
    const key = byObject ? object : geometry;
    if (seen.has(key)) return;
    if (this.left === 0) {
      this.cut = true;
      return;
    }
    this.left--;
    seen.add(key);
    const { frame } = this;
    try {
      frame.draw(frame.camera, frame.scene, geometry, material, object, group);
    } catch (error) {
      if (error !== STOP) throw error;
    }
  }
}
