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
import type { MicroShaderRegistry } from '../../microshaders';
import type { GeometryGroup } from '../../three/RenderListItem';
import { CasterMaterials } from '../casters/CasterMaterials';
import { casterProxy } from '../casters/casterProxy';
import { MergedCasters } from '../casters/merged';
import { VisibleReceivers } from '../receivers';
import type { Caster } from '../casters/Caster';
import { isInFace, isInMap } from '../casters/isInMap';
import type { ShadowCasters } from '../casters/ShadowCasters';
import type { ShadowFace } from '../slots/ShadowFace';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { TextureAtlas } from '../atlas/TextureAtlas';
import { directDraw, type DirectDraw } from '../../three/directDraw';
import { isDepthReversed, setScissor, setViewport, testScissor, unmaskDepth } from '../../three/state';

type ShadowCallback = (
  renderer: WebGLRenderer,
  object: Object3D,
  camera: Camera,
  shadowCamera: Camera,
  geometry: BufferGeometry,
  material: Material,
  group: GeometryGroup | null,
) => void;

/** Number of frames without a change after which a partly drawn shadow map is drawn whole. */
const REST = 60;

const rectangle = new Vector4();
const depth = new Float32Array(1);

const isCovered = (face: ShadowFace) => face.isCovered;

/** Draws casters into shadow maps as three's WebGLShadowMap would. Call inside three's `render`. */
export class ShadowMapDraws {
  /** Proxies of the casters that the frame draws, by which three updates their buffers. */
  readonly proxies: Object3D[] = [];
  private readonly materials: CasterMaterials;
  private readonly draw: DirectDraw;
  private readonly gl: WebGL2RenderingContext;
  private readonly merged = new Map<ShadowCasters, MergedCasters>();
  private mergedCasters: MergedCasters | null = null;
  private hasMerged = false;
  private readonly receivers = new VisibleReceivers();
  private hasReceivers = false;
  private casters: ShadowCasters | null = null;
  /** Casters of the frame that are not merged, but drawn one by one. */
  private readonly loose: Caster[] = [];
  private camera: Camera | null = null;
  private bothSides = false;
  private frame = 0;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly microshaders: MicroShaderRegistry,
  ) {
    this.materials = new CasterMaterials(webgl, microshaders);
    this.draw = directDraw(webgl);
    this.gl = webgl.getContext() as WebGL2RenderingContext;
  }

  /**
   * Begins a frame.
   * @param bothSides - whether to draw the sides of casters that pictures show, as three does for variance shadow maps
   */
  begin(casters: ShadowCasters, camera: Camera, bothSides: boolean): void {
    this.casters = casters;
    this.camera = camera;
    this.bothSides = bothSides;
    this.frame++;
    this.proxies.length = 0;
    this.mergedCasters = this.mergedOf(casters);
    this.hasMerged = this.hasReceivers = false;
  }

  /** Finds the casters that each face of a light's map will draw, and adds proxies by which three uploads their buffers. */
  prepare(slot: ShadowSlot): void {
    const merged = this.beginMerged();
    for (const face of slot.faces) face.clear();
    merged?.addTo(slot, this.bothSides);
    for (const caster of this.loose) {
      if (!isInMap(caster, slot)) continue;
      for (const face of slot.faces) {
        if (!isInFace(caster, face)) continue;
        face.casters.push(caster);
        if (caster.proxyFrame === this.frame) continue;
        caster.proxyFrame = this.frame;
        caster.proxy ??= casterProxy(caster.object);
        this.proxies.push(caster.proxy);
      }
    }
  }

  /**
   * Whether only the visible parts of a map need to be drawn: the map changes every frame, or it is partial, unchanged, and its
   * drawn parts still cover the visible ones. Finds the visible parts if needed.
   * @param mayDraw - whether the map may be drawn in this frame
   */
  isPart(slot: ShadowSlot, mayDraw: boolean, frame: number): boolean {
    const { map, placement } = slot;
    const { since } = map;
    map.noteAge(frame);
    if (this.bothSides || placement.region === null) return false;
    if (mayDraw && !map.isCurrent) {
      const goesOn = map.isThere && since === frame - 1;
      return goesOn && slot.shadow.autoUpdate && this.findParts(slot);
    }
    // a partial map is completed after some frames without change; the number differs by record, which spreads the draws
    if (!map.isPartial || (mayDraw && frame - since > REST + (slot.record & 7))) return false;
    return this.findParts(slot) && slot.faces.every(isCovered);
  }

  /** Finds the visible part of each face of a map. @returns false if that is the whole map */
  private findParts(slot: ShadowSlot): boolean {
    if (!this.hasReceivers) {
      this.hasReceivers = true;
      this.receivers.find(this.casters!, this.beginMerged(), this.camera!);
    }
    return this.receivers.findParts(slot);
  }

  /** Uploads the data of the merged casters. */
  send(): void {
    this.mergedCasters?.prepare();
  }

  /** Sets the comparison of the depth atlas's sampler to the direction of the depth buffer, reversed or not. */
  setComparison(atlas: TextureAtlas): void {
    const texture = atlas.target?.depthTexture;
    const wanted = isDepthReversed(this.webgl) ? GreaterEqualCompare : LessEqualCompare;
    if (texture && texture.compareFunction !== wanted) texture.compareFunction = wanted;
  }

  /** Draws the planned parts of maps into the bound target. */
  drawMaps(slots: readonly ShadowSlot[]): void {
    this.beginFaces();
    for (const slot of slots) for (const face of slot.faces) this.drawFace(slot, face, face.x, face.y);
    testScissor(this.webgl, false);
  }

  /** Draws one face at the origin of the bound target. */
  drawAlone(slot: ShadowSlot, face: ShadowFace): void {
    this.beginFaces();
    this.mergedCasters?.interrupt(); // blurring has changed the GPU state since the last face
    this.drawFace(slot, face, 0, 0);
    testScissor(this.webgl, false);
  }

  release(casters: ShadowCasters): void {
    this.merged.get(casters)?.dispose();
    this.merged.delete(casters);
    if (this.casters !== casters) return;
    this.casters = this.mergedCasters = null;
    this.proxies.length = this.loose.length = 0;
  }

  dispose(): void {
    this.materials.dispose();
    for (const merged of this.merged.values()) merged.dispose();
    this.merged.clear();
  }

  /** The merged casters of a scene; null where depth is logarithmic, which only three's own materials write. */
  private mergedOf(casters: ShadowCasters): MergedCasters | null {
    if (this.webgl.capabilities.logarithmicDepthBuffer) return null;
    let merged = this.merged.get(casters);
    if (merged === undefined) {
      merged = new MergedCasters(this.webgl, this.microshaders);
      this.merged.set(casters, merged);
    }
    return merged;
  }

  /** Brings the merged casters up to date, once in a frame that draws maps. */
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
    merged.addProxies(this.proxies);
    return merged;
  }

  private beginFaces(): void {
    const { webgl } = this;
    testScissor(webgl, true);
    unmaskDepth(webgl);
    depth[0] = isDepthReversed(webgl) ? 0 : 1;
  }

  /** Clears the drawn part of a face, then draws the face's casters. */
  private drawFace(slot: ShadowSlot, face: ShadowFace, x: number, y: number): void {
    if (face.texels === 0) return;
    const { gl, mergedCasters, webgl } = this;
    const { left, bottom, right, top } = face.drawn;
    setViewport(webgl, rectangle.set(x, y, face.width, face.height));
    setScissor(webgl, rectangle.set(x + left, y + bottom, right - left, top - bottom));
    gl.clearBufferfv(gl.DEPTH, 0, depth);
    mergedCasters?.draw(face);
    if (face.casters.length === 0) return;
    mergedCasters?.interrupt();
    for (const caster of face.casters) this.drawCaster(caster, slot, face);
    // materials of casters may have masked depth writes
    unmaskDepth(webgl);
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
