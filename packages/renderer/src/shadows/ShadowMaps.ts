import {
  BasicShadowMap,
  type BufferGeometry,
  type Camera,
  type Light,
  type Material,
  type Mesh,
  NoBlending,
  type Object3D,
  VSMShadowMap,
  Vector3,
  Vector4,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import type { DataTable } from '../lights/DataTable';
import { FLOATS_PER_RECORD } from '../lights/lightRecord';
import type { LightMasks } from '../lights/LightTable';
import type { GeometryGroup } from '../RenderItem';
import { sphereOutsidePlanes } from '../lights/sphereOutsidePlanes';
import { CasterMaterials } from './CasterMaterials';
import { casterStand } from './casterStand';
import { RECORDS_PER_MASK, shadowKinds, writeMaskMatrix } from './maskRecord';
import { ShadowAtlas } from './ShadowAtlas';
import { ShadowCasters, type Caster } from './ShadowCasters';
import type { ShadowFace } from './ShadowFace';
import { CUBE_BORDER, type ShadowLight, ShadowSlot } from './ShadowSlot';

/** Frames for which the map of a light that is not lit is kept. */
const KEPT_FRAMES = 600;
/** Frames between looks at whose maps are halved, when the atlas is full. */
const REBALANCE = 60;

type Draw = (
  camera: Camera,
  scene: null,
  geometry: BufferGeometry,
  material: Material,
  object: Object3D,
  group: GeometryGroup | null,
) => void;

const position = new Vector3();
const rectangle = new Vector4();
const depth = new Float32Array(1);

/**
 * The shadow maps of all lights of a renderer, in one atlas: which of them are to be drawn this frame, and the drawing.
 * A map is kept until something that casts shadows changes within its view, or the light does.
 */
export class ShadowMaps implements LightMasks {
  records = 0;
  /** Stand-ins of the casters that are drawn this frame, for three to bring their buffers up to date. */
  readonly stands: Object3D[] = [];
  /** Maps that this frame draws (a point light has one), and those that it lights with as they are. */
  drawn = 0;
  kept = 0;
  readonly atlas: ShadowAtlas;
  private readonly slots = new Map<Light, ShadowSlot>();
  private readonly lit: ShadowSlot[] = [];
  private readonly unlit: ShadowSlot[] = [];
  private readonly stale: ShadowSlot[] = [];
  private readonly casters = new WeakMap<Object3D, ShadowCasters>();
  private readonly materials: CasterMaterials;
  private readonly draw: Draw;
  private current: ShadowCasters | null = null;
  private camera: Camera | null = null;
  private type = -1;
  private frame = 0;
  private count = 0;

  /** @param limit of the atlas, texels a side */
  constructor(
    private readonly webgl: WebGLRenderer,
    limit: number,
  ) {
    this.atlas = new ShadowAtlas(Math.min(limit, webgl.capabilities.maxTextureSize));
    this.materials = new CasterMaterials(webgl);
    this.draw = webgl.renderBufferDirect as unknown as Draw;
  }

  /** True when the next frame has maps to draw. */
  get hasWork(): boolean {
    return this.stale.length > 0;
  }

  /**
   * Finds out which maps a frame needs and which of them have to be drawn.
   * @param lights those that may be masked, of this frame
   */
  update(root: Object3D, camera: Camera, lights: readonly Light[]): void {
    this.frame++;
    this.lit.length = this.stale.length = this.stands.length = 0;
    this.records = this.drawn = this.kept = 0;
    const { shadowMap } = this.webgl;
    this.camera = camera;
    for (const light of lights) this.addLight(light, root, camera);
    if (this.lit.length === 0 && this.slots.size === 0) return;
    if (shadowMap.type !== this.type) {
      this.type = shadowMap.type;
      for (const slot of this.slots.values()) slot.dirty = true;
    }
    this.dropLost();
    this.findChanges(root, camera);
    this.follow(shadowMap.autoUpdate || shadowMap.needsUpdate);
    this.forget();
    const changed = this.lit.length !== this.count;
    this.count = this.lit.length;
    this.atlas.arrange(this.lit, this.unlit, changed || this.frame % REBALANCE === 0);
    this.findStale(shadowMap.autoUpdate || shadowMap.needsUpdate);
  }

  recordOf(light: Light): number {
    const slot = this.slots.get(light);
    return slot === undefined || slot.used !== this.frame ? -1 : slot.record;
  }

  write(table: DataTable, first: number, camera: Camera): void {
    for (const slot of this.lit) if (slot.record >= 0) this.writeSlot(table, first + slot.record, slot, camera);
  }

  /** Draws the maps that are to be drawn. Call inside three's `render`, where it draws its own. */
  render(): void {
    const { webgl, stale } = this;
    const { state } = webgl;
    const target = webgl.getRenderTarget() as WebGLRenderTarget | null;
    const face = webgl.getActiveCubeFace();
    const level = webgl.getActiveMipmapLevel();
    const reversed = state.buffers.depth.getReversed();
    this.atlas.setReversed(reversed);
    webgl.setRenderTarget(this.atlas.target);
    state.setBlending(NoBlending);
    state.buffers.depth.setTest(true);
    depth[0] = reversed ? 0 : 1;
    for (const slot of stale) {
      for (const tile of slot.faces) this.drawFace(slot, tile);
      slot.dirty = false;
      slot.drawn = slot.hadMap = true;
      const { shadow } = slot.light;
      if (shadow.needsUpdate) shadow.needsUpdate = false;
    }
    state.setScissorTest(false);
    webgl.setRenderTarget(target, face, level);
  }

  /** Ends a frame: what the host asked for once is done. */
  end(): void {
    const { shadowMap } = this.webgl;
    if (this.lit.length > 0 && shadowMap.needsUpdate) shadowMap.needsUpdate = false;
  }

  dispose(): void {
    this.atlas.dispose();
    this.materials.dispose();
    this.slots.clear();
  }

  private addLight(anyLight: Light, root: Object3D, camera: Camera): void {
    const { shadowMap } = this.webgl;
    if (!anyLight.castShadow || !shadowMap.enabled) return;
    const light = anyLight as ShadowLight;
    if (shadowMap.type === VSMShadowMap && light.isPointLight) return;
    let slot = this.slots.get(light);
    if (slot !== undefined && slot.shadow !== light.shadow) {
      this.atlas.release(slot);
      slot = undefined;
    }
    if (slot === undefined) {
      slot = new ShadowSlot(light);
      this.slots.set(light, slot);
    }
    slot.root = root;
    slot.used = this.frame;
    slot.coverage = coverageOf(light, camera);
    const { mask } = light.shadow.camera.layers;
    const layers = (mask & 0xfffffffe) !== 0 ? mask : camera.layers.mask;
    if (slot.layers !== layers) {
      slot.layers = layers;
      slot.dirty = true;
    }
    this.lit.push(slot);
  }

  /** Marks the maps that see something that changed; also those of lights that are not lit now. */
  private findChanges(root: Object3D, camera: Camera): void {
    let casters = this.casters.get(root);
    if (casters === undefined) this.casters.set(root, (casters = new ShadowCasters()));
    casters.update(root, camera, this.type === VSMShadowMap);
    this.current = casters;
    const { changes, changed } = casters;
    for (const slot of this.slots.values()) {
      if (slot.root !== root) continue;
      for (let i = 0; i < changed * 4 && !slot.dirty; i += 4) {
        if (slot.reaches(changes[i], changes[i + 1], changes[i + 2], changes[i + 3])) slot.dirty = true;
      }
    }
  }

  private follow(updates: boolean): void {
    const reversed = this.webgl.state.buffers.depth.getReversed();
    for (const slot of this.lit) {
      const { shadow } = slot.light;
      if (shadow.needsUpdate) slot.dirty = true;
      if (!slot.hadMap || (updates && (shadow.autoUpdate || shadow.needsUpdate))) slot.follow(reversed);
    }
  }

  private findStale(updates: boolean): void {
    for (const slot of this.lit) {
      const { shadow } = slot.light;
      const may = (updates && (shadow.autoUpdate || shadow.needsUpdate)) || (slot.hadMap && !slot.drawn);
      if (slot.tile !== null && may && (slot.dirty || !slot.drawn)) {
        this.stale.push(slot);
        this.drawn++;
        for (const face of slot.faces) this.prepare(slot, face);
      } else if (slot.drawn) this.kept++;
      // a light whose first map may not be drawn yet casts no shadow
      slot.record = slot.tile !== null && (slot.drawn || may) ? this.records : -1;
      if (slot.record >= 0) this.records += RECORDS_PER_MASK;
    }
  }

  private forget(): void {
    this.unlit.length = 0;
    for (const slot of this.slots.values()) {
      if (slot.used === this.frame) continue;
      slot.record = -1;
      this.unlit.push(slot);
      if (this.frame - slot.used <= KEPT_FRAMES) continue;
      this.atlas.release(slot);
      this.slots.delete(slot.light);
    }
  }

  /** A lost context takes the maps along. */
  private dropLost(): void {
    const { texture } = this.atlas;
    if (texture === null) return;
    const { __webglTexture } = this.webgl.properties.get(texture) as { __webglTexture?: WebGLTexture };
    if (__webglTexture === undefined) for (const slot of this.slots.values()) slot.drawn = false;
  }

  /** Has three bring the buffers of what a face will draw up to date. */
  private prepare(slot: ShadowSlot, face: ShadowFace): void {
    const { list, count } = this.current!;
    for (let i = 0; i < count; i++) {
      const caster = list[i];
      if (caster.prepared === this.frame || !isSeen(caster, slot, face)) continue;
      caster.prepared = this.frame;
      caster.stand ??= casterStand(caster.object);
      this.stands.push(caster.stand);
    }
  }

  private drawFace(slot: ShadowSlot, face: ShadowFace): void {
    const { webgl } = this;
    const { state } = webgl;
    rectangle.set(face.x, face.y, face.width, face.height);
    state.viewport(rectangle);
    state.scissor(rectangle);
    state.setScissorTest(true);
    state.buffers.depth.setMask(true);
    const gl = webgl.getContext() as WebGL2RenderingContext;
    gl.clearBufferfv(gl.DEPTH, 0, depth);
    const { list, count } = this.current!;
    for (let i = 0; i < count; i++) if (isSeen(list[i], slot, face)) this.drawCaster(list[i].object, slot, face);
  }

  private drawCaster(object: Object3D, slot: ShadowSlot, face: ShadowFace): void {
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
    const material = this.materials.get(object, source, slot.light, this.type === VSMShadowMap);
    const before = object.onBeforeShadow as unknown as ShadowCallback;
    const after = object.onAfterShadow as unknown as ShadowCallback;
    before.call(object, webgl, object, this.camera!, face.camera, geometry, material, group);
    this.draw(face.camera, null, geometry, material, object, group);
    after.call(object, webgl, object, this.camera!, face.camera, geometry, material, group);
  }

  private writeSlot(table: DataTable, record: number, slot: ShadowSlot, camera: Camera): void {
    const { tile, isPoint, light, near, far } = slot;
    const { shadow } = light;
    const reversed = this.webgl.state.buffers.depth.getReversed();
    const at = record * FLOATS_PER_RECORD;
    writeMaskMatrix(table, record, slot.matrix, camera);
    const bias = reversed ? -shadow.bias : shadow.bias;
    const basic = this.type === BasicShadowMap;
    if (isPoint) table.set4(at + 16, tile!.x, tile!.y, slot.faceWidth, slot.faceWidth + 2 * CUBE_BORDER);
    else table.set4(at + 16, tile!.x, tile!.y, slot.faceWidth, slot.faceHeight);
    table.set4(at + 20, bias, shadow.normalBias, shadow.radius, shadow.intensity);
    const kind = isPoint
      ? basic
        ? shadowKinds.cubeBasic
        : shadowKinds.cubePcf
      : basic
        ? shadowKinds.basic
        : shadowKinds.pcf;
    table.set4(at + 24, kind, shadow.mapSize.x, shadow.mapSize.y, 0);
    const depthRange = far - near;
    if (reversed) table.set4(at + 28, -near / depthRange + bias, (near * far) / depthRange, near, far);
    else table.set4(at + 28, far / depthRange + bias, (-near * far) / depthRange, near, far);
  }
}

type ShadowCallback = (
  renderer: WebGLRenderer,
  object: Object3D,
  camera: Camera,
  shadowCamera: Camera,
  geometry: BufferGeometry,
  material: Material,
  group: GeometryGroup | null,
) => void;

function isSeen(caster: Caster, slot: ShadowSlot, face: ShadowFace): boolean {
  if ((caster.object.layers.mask & slot.layers) === 0) return false;
  const { x, y, z, radius } = caster;
  if (radius === Infinity) return true;
  return !sphereOutsidePlanes(face.planes, x, y, z, radius) && (!slot.isPoint || slot.reaches(x, y, z, radius));
}

/** Share of the picture that a light covers, roughly, 0 to 1. */
function coverageOf(light: ShadowLight, camera: Camera): number {
  const range = (light as { distance?: number }).distance ?? 0;
  if (range <= 0) return 1;
  const p = camera.projectionMatrix.elements;
  const away = -position.setFromMatrixPosition(light.matrixWorld).applyMatrix4(camera.matrixWorldInverse).z;
  const scale = p[11] === 0 ? range : range / Math.max(away, range);
  return Math.min(1, (Math.PI / 4) * scale * scale * Math.abs(p[0] * p[5]));
}
