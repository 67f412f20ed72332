import {
  type BufferGeometry,
  type Camera,
  GreaterEqualCompare,
  LessEqualCompare,
  type Material,
  type Mesh,
  type Object3D,
  Vector4,
  type WebGLRenderer,
} from 'three';
import type { MicroShaderRegistry } from '../../../microshaders';
import type { GeometryGroup } from '../../../frame/RenderItem';
import { CasterMaterials } from '../casters/CasterMaterials';
import { casterStand } from '../casters/casterStand';
import { MergedCasters } from '../casters/merged';
import { SeenReceivers } from '../receivers';
import { type Caster, isReached, isSeen, type ShadowCasters } from '../casters/ShadowCasters';
import type { ShadowFace } from '../slots/ShadowFace';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { TileAtlas } from '../atlas/TileAtlas';

export type Draw = (
  camera: Camera,
  scene: null,
  geometry: BufferGeometry,
  material: Material,
  object: Object3D,
  group: GeometryGroup | null,
) => void;

type ShadowCallback = (
  renderer: WebGLRenderer,
  object: Object3D,
  camera: Camera,
  shadowCamera: Camera,
  geometry: BufferGeometry,
  material: Material,
  group: GeometryGroup | null,
) => void;

/** Frames after which a map that holds only what could be seen is drawn whole, if nothing changes in it. */
const REST = 60;

const rectangle = new Vector4();
const depth = new Float32Array(1);

const isCovered = (face: ShadowFace) => face.isCovered;

/** Draws casters into the tiles of shadow maps as three's WebGLShadowMap would. Call inside three's `render`. */
export class ShadowMapDraws {
  /** Stand-ins of the casters that are drawn this frame, for three to bring their buffers up to date. */
  readonly stands: Object3D[] = [];
  private readonly materials: CasterMaterials;
  private readonly draw: Draw;
  private readonly gl: WebGL2RenderingContext;
  private readonly merged = new Map<ShadowCasters, MergedCasters>();
  private mergedCasters: MergedCasters | null = null;
  private hasMerged = false;
  private readonly seen = new SeenReceivers();
  private hasSeen = false;
  private casters: ShadowCasters | null = null;
  /** Those of the frame that are drawn one by one. */
  private readonly loose: Caster[] = [];
  private camera: Camera | null = null;
  private bothSides = false;
  private frame = 0;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly microshaders: MicroShaderRegistry,
  ) {
    this.materials = new CasterMaterials(webgl);
    this.draw = webgl.renderBufferDirect as unknown as Draw;
    this.gl = webgl.getContext() as WebGL2RenderingContext;
  }

  /**
   * Begins a frame.
   * @param bothSides the sides that are seen cast shadows, as for variance shadow maps
   */
  begin(casters: ShadowCasters, camera: Camera, bothSides: boolean): void {
    this.casters = casters;
    this.camera = camera;
    this.bothSides = bothSides;
    this.frame++;
    this.stands.length = 0;
    this.mergedCasters = this.mergedOf(casters);
    this.hasMerged = this.hasSeen = false;
  }

  /** Finds what each face of a light's map will draw, and has three bring its buffers up to date. */
  prepare(slot: ShadowSlot): void {
    const merged = this.beginMerged();
    for (const face of slot.faces) face.clear();
    merged?.addTo(slot, this.bothSides);
    for (const caster of this.loose) {
      if (!isReached(caster, slot)) continue;
      for (const face of slot.faces) {
        if (!isSeen(caster, face)) continue;
        face.casters.push(caster);
        if (caster.prepared === this.frame) continue;
        caster.prepared = this.frame;
        caster.stand ??= casterStand(caster.object);
        this.stands.push(caster.stand);
      }
    }
  }

  /**
   * Whether a map that changes in frame after frame need hold no more than what can be seen of it, or one that has stopped to
   * do so holds all of that. Finds the parts of its faces.
   * @param may be drawn in this frame
   */
  isPart(slot: ShadowSlot, may: boolean, frame: number): boolean {
    const { dirty, drawn, changed, isPartial } = slot;
    if (dirty) slot.changed = frame;
    if (this.bothSides || slot.tile === null) return false;
    if (may && (dirty || !drawn)) {
      const goesOn = drawn && changed === frame - 1;
      return goesOn && slot.light.shadow.autoUpdate && this.cut(slot);
    }
    // at rest the whole is drawn some time, a few maps a frame
    if (!isPartial || (may && frame - changed > REST + (slot.record & 7))) return false;
    return this.cut(slot) && slot.faces.every(isCovered);
  }

  /** Has each face of a light's map draw only what can be seen of it. @returns false where that is all */
  private cut(slot: ShadowSlot): boolean {
    if (!this.hasSeen) {
      this.hasSeen = true;
      this.seen.find(this.casters!, this.beginMerged(), this.camera!);
    }
    return this.seen.cut(slot);
  }

  /** Sends what the draws of a frame need. */
  send(): void {
    this.mergedCasters?.prepare();
  }

  /** Has the sampler of an atlas of depths compare as the depth buffer is kept. */
  setComparison(atlas: TileAtlas): void {
    const texture = atlas.target?.depthTexture;
    const wanted = this.webgl.state.buffers.depth.getReversed() ? GreaterEqualCompare : LessEqualCompare;
    if (texture && texture.compareFunction !== wanted) texture.compareFunction = wanted;
  }

  /** Draws the maps of lights into the bound target, as far as they are to be drawn. */
  drawMaps(slots: readonly ShadowSlot[]): void {
    this.beginFaces();
    for (const slot of slots) for (const face of slot.faces) this.drawFace(slot, face, face.x, face.y);
    this.webgl.state.setScissorTest(false);
  }

  /** Draws one face at the origin of the bound target. */
  drawAlone(slot: ShadowSlot, face: ShadowFace): void {
    this.beginFaces();
    this.mergedCasters?.interrupt(); // others were drawn since the last
    this.drawFace(slot, face, 0, 0);
    this.webgl.state.setScissorTest(false);
  }

  /** Lets go of the casters of a scene. */
  release(casters: ShadowCasters): void {
    this.merged.get(casters)?.dispose();
    this.merged.delete(casters);
    if (this.casters !== casters) return;
    this.casters = this.mergedCasters = null;
    this.stands.length = this.loose.length = 0;
  }

  dispose(): void {
    this.materials.dispose();
    for (const merged of this.merged.values()) merged.dispose();
    this.merged.clear();
  }

  /** Those of a scene; none where depth is logarithmic, which three's own materials write. */
  private mergedOf(casters: ShadowCasters): MergedCasters | null {
    if (this.webgl.capabilities.logarithmicDepthBuffer) return null;
    let merged = this.merged.get(casters);
    if (merged === undefined) {
      merged = new MergedCasters(this.webgl, this.microshaders);
      this.merged.set(casters, merged);
    }
    return merged;
  }

  /** Has them ready, once a frame that draws maps. */
  private beginMerged(): MergedCasters | null {
    const merged = this.mergedCasters;
    if (this.hasMerged) return merged;
    this.hasMerged = true;
    this.loose.length = 0;
    if (merged === null) {
      const { list, count } = this.casters!;
      for (let i = 0; i < count; i++) this.loose.push(list[i]);
      return null;
    }
    merged.begin(this.camera!, this.casters!, this.loose);
    merged.addStands(this.stands);
    return merged;
  }

  private beginFaces(): void {
    const { state } = this.webgl;
    state.setScissorTest(true);
    this.prepareDepth();
    depth[0] = state.buffers.depth.getReversed() ? 0 : 1;
  }

  /** Clears what is drawn of a face, then draws the casters that it sees. */
  private drawFace(slot: ShadowSlot, face: ShadowFace, x: number, y: number): void {
    if (face.texels === 0) return;
    const { gl, mergedCasters } = this;
    const { state } = this.webgl;
    const { left, bottom, right, top } = face.drawn;
    state.viewport(rectangle.set(x, y, face.width, face.height));
    state.scissor(rectangle.set(x + left, y + bottom, right - left, top - bottom));
    gl.clearBufferfv(gl.DEPTH, 0, depth);
    mergedCasters?.draw(face);
    if (face.casters.length === 0) return;
    mergedCasters?.interrupt();
    for (const caster of face.casters) this.drawCaster(caster, slot, face);
    this.prepareDepth();
  }

  /** So that depths are cleared, whatever the materials of the last casters were. */
  private prepareDepth(): void {
    const { depth } = this.webgl.state.buffers;
    depth.setTest(true);
    depth.setMask(true);
  }

  private drawCaster({ object }: Caster, slot: ShadowSlot, face: ShadowFace): void {
    const { geometry, material } = object as Mesh;
    object.modelViewMatrix.multiplyMatrices(face.camera.matrixWorldInverse, object.matrixWorld);
    if (!Array.isArray(material)) {
      if (material.visible) this.drawPart(object, geometry, material, null, slot, face);
      return;
    }
    for (const group of geometry.groups) {
      const part = material[group.materialIndex ?? 0] as Material | undefined;
      if (part?.visible) this.drawPart(object, geometry, part, group, slot, face);
    }
  }

  private drawPart(
    object: Object3D,
    geometry: BufferGeometry,
    source: Material,
    group: GeometryGroup | null,
    slot: ShadowSlot,
    face: ShadowFace,
  ): void {
    const { webgl } = this;
    const camera = this.camera!;
    const material = this.materials.get(object, source, slot.light, this.bothSides);
    const before = object.onBeforeShadow as unknown as ShadowCallback;
    const after = object.onAfterShadow as unknown as ShadowCallback;
    before.call(object, webgl, object, camera, face.camera, geometry, material, group);
    this.draw(face.camera, null, geometry, material, object, group);
    after.call(object, webgl, object, camera, face.camera, geometry, material, group);
  }
}
