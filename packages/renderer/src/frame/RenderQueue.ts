import {
  type BatchedMesh,
  type BufferGeometry,
  type Camera,
  Material,
  Object3D,
  type ShaderMaterial,
  Sphere,
} from 'three';
import { isOrderSensitive, isPlainOpaque } from '../gbuffer/shadingModel';
import { hasNodes } from '../three/hasNodes';
import { isLit } from '../materials/isLit';
import { isGouraud } from '../materials/shadingOf';
import { RefusedMaterials } from '../materials/RefusedMaterials';
import { threeChunks } from '../three/ThreeChunks';
import type { TwinKind } from '../materials/TwinKind';
import type { GeometryGroup, RenderItem } from './RenderItem';
import { warnOfNaN } from './warnOfNaN';

export type RenderItemSort = (a: RenderItem, b: RenderItem) => number;

/** three's default order of opaque items: by group, render order, material, then front to back. */
function byState(a: RenderItem, b: RenderItem): number {
  return (
    a.groupOrder - b.groupOrder ||
    a.renderOrder - b.renderOrder ||
    a.material.id - b.material.id ||
    a.materialVariant - b.materialVariant ||
    a.z - b.z ||
    a.id - b.id
  );
}

/** three's default order of transparent items: by group, render order, then back to front. */
function backToFront(a: RenderItem, b: RenderItem): number {
  return a.groupOrder - b.groupOrder || a.renderOrder - b.renderOrder || b.z - a.z || a.id - b.id;
}

/** Whether a material has another shader than three's for its class. */
export function hasOwnShader(material: Material): boolean {
  return (
    (material as ShaderMaterial).isShaderMaterial === true ||
    material.onBeforeCompile !== Material.prototype.onBeforeCompile
  );
}

const reach = new Sphere();
const { onBeforeRender, onAfterRender } = Object3D.prototype;

const clearing = new WeakMap<object, boolean>();

/**
 * Whether a callback, by its source text, clears depth but not colour, or draws without setting a target: such steps
 * belong in the host's target, not in several textures at once.
 */
function clears(callback: (...all: never[]) => void): boolean {
  let known = clearing.get(callback);
  if (known === undefined)
    clearing.set(
      callback,
      (known = /clear(Depth|\((false|!1))|^(?!.*setRenderTarget).*\.render\(/s.test(String(callback))),
    );
  return known;
}

/**
 * Whether an object's callbacks may clear depth or draw, by their source text; any callback counts if `hasPlace`.
 */
function isStepOfHost(object: Object3D, hasPlace: boolean): boolean {
  const { onBeforeRender: before, onAfterRender: after } = object;
  if ((before === onBeforeRender && after === onAfterRender) || (object as BatchedMesh).isBatchedMesh) return false; // three's own
  return hasPlace || clears(before) || clears(after);
}

/** Materials that show shadows by three's `getShadowMask()`, and the kind of twins that shows Farol's. */
export interface ShadowMaskMaterials {
  shows(material: Material): boolean;
  readonly twin: TwinKind;
}

/** Objects that a frame draws, in the three lists of three.js. Items are pooled. */
export class RenderQueue {
  readonly opaque: RenderItem[] = [];
  readonly transmissive: RenderItem[] = [];
  readonly transparent: RenderItem[] = [];
  private readonly pool: RenderItem[] = [];
  /** Layers of items that are not `layered`; 0 when lights ignore layers. */
  layers = 0;
  /** Draws materials that show nothing but shadows; null while three draws them. */
  shadowMasks: ShadowMaskMaterials | null = null;
  /** True if every opaque item is plain, and its material writes the geometry's depth. */
  covers = true;
  /** True if an opaque object may be so far away that its depth equals the cleared depth, see `watchFar`. */
  reachesFar = false;
  private camera!: Camera;
  /** Distance (m) from which on depth equals the cleared depth; -Infinity if depth gives no distance. */
  farthest = Infinity;
  /** Materials that only three's own lights can light. */
  readonly refused = new RefusedMaterials();
  /** Number of first opaque items that are drawn into the target before anything else. */
  early = 0;
  /** True if an opaque item must be drawn in three's order. */
  ordered = false;
  /** True if a lit object is transmissive or transparent. */
  hasLitTransparents = false;
  private used = 0;
  private opaques = 0;
  private transmissives = 0;
  private transparents = 0;

  clear(): void {
    this.used = 0;
    this.covers = true;
    this.ordered = false;
    this.early = 0;
    this.reachesFar = this.farthest === -Infinity;
    this.hasLitTransparents = false;
    this.opaques = this.transmissives = this.transparents = 0;
  }

  /** Tests opaque items, from the next `clear` on, for objects beyond a distance along the view (m). */
  watchFar(camera: Camera, distance: number): void {
    this.camera = camera;
    this.farthest = distance;
  }

  push(
    object: Object3D,
    geometry: BufferGeometry,
    material: Material,
    groupOrder: number,
    z: number,
    group: GeometryGroup | null,
    override: Material | null,
  ): void {
    const list =
      ((material as Material & { transmission?: number }).transmission ?? 0) > 0
        ? this.transmissive
        : material.transparent
          ? this.transparent
          : this.opaque;
    if (override !== null && material.allowOverride) material = override;
    if (z !== z) warnOfNaN(this.camera, object);
    let item = this.pool[this.used];
    if (item === undefined) this.pool.push((item = {} as RenderItem));
    this.used++;
    const o = object as Object3D & { isInstancedMesh?: boolean; isSkinnedMesh?: boolean };
    item.id = object.id;
    item.object = object;
    item.geometry = geometry;
    item.material = material;
    item.materialVariant = (o.isInstancedMesh ? 2 : 0) + (o.isSkinnedMesh ? 1 : 0);
    item.group = group;
    item.groupOrder = groupOrder;
    item.renderOrder = object.renderOrder;
    item.z = z;
    item.nodes = hasNodes(material);
    const ownShader = item.nodes || threeChunks.shading || hasOwnShader(material) || isGouraud(material);
    item.lit = !item.nodes && !threeChunks.lights && isLit(material) && !(ownShader && this.refused.has(material));
    item.shadowMask =
      !item.lit && this.shadowMasks?.shows(material) === true && !(ownShader && this.refused.has(material));
    item.ownShader = ownShader;
    if (ownShader && !item.lit && !item.nodes && (material as ShaderMaterial).lights === true)
      this.refused.look(material as ShaderMaterial);
    const isStep = isStepOfHost(object, groupOrder !== 0 || object.renderOrder !== 0);
    item.plain = list === this.opaque && isPlainOpaque(material) && !isStep;
    item.ordered = list === this.opaque && !item.plain && (isStep || isOrderSensitive(material));
    item.layered = this.layers !== 0 && object.layers.mask !== this.layers;
    item.drawn = false;
    item.splits = item.plain && item.lit && !ownShader;
    if (list === this.opaque) {
      // its depth does not match its position
      if (material.polygonOffset) this.farthest = -Infinity;
      if (!this.reachesFar && this.farthest !== Infinity) this.reachesFar = this.reaches(object, geometry);
    }
    if (item.lit && list !== this.opaque) this.hasLitTransparents = true;
    if (list === this.opaque && (!item.plain || ownShader)) this.covers = false;
    if (item.ordered) this.ordered = true;
    // the lists are cut to their length when all is in, and so keep their storage
    if (list === this.opaque) list[this.opaques++] = item;
    else if (list === this.transparent) list[this.transparents++] = item;
    else list[this.transmissives++] = item;
  }

  /** Whether an object's bounding sphere reaches `farthest`; true without a sphere. */
  private reaches(object: Object3D, geometry: BufferGeometry): boolean {
    const sphere = (object as Object3D & { boundingSphere?: Sphere | null }).boundingSphere ?? geometry.boundingSphere;
    if (sphere === null || !object.frustumCulled) return true;
    const { center, radius } = reach.copy(sphere).applyMatrix4(object.matrixWorld);
    const v = this.camera.matrixWorldInverse.elements;
    return !(radius - (v[2] * center.x + v[6] * center.y + v[10] * center.z + v[14]) <= this.farthest);
  }

  /** Ends the lists, and drops references to objects of earlier, larger frames. */
  finish(): void {
    this.opaque.length = this.opaques;
    this.transmissive.length = this.transmissives;
    this.transparent.length = this.transparents;
    for (let i = this.used; i < this.pool.length && this.pool[i].object !== null; i++) {
      const item = this.pool[i] as { -readonly [K in keyof RenderItem]: RenderItem[K] | null };
      item.object = item.geometry = item.material = item.group = null;
    }
  }

  /**
   * Keeps to three's order where it shows. What comes before an item that must be drawn in order, and after nothing that
   * passes draw in an order of their own, is drawn early; what comes after such items is left to the forward draws.
   */
  keepOrder(): void {
    if (!this.ordered) return;
    const { opaque } = this;
    let split = false;
    let behind = false;
    for (let i = 0; i < opaque.length; i++) {
      const item = opaque[i];
      if (item.plain) {
        if (behind) item.plain = item.splits = false;
        else if (item.splits) split = true;
      } else if (item.ordered) {
        if (split) behind = true;
        else this.early = i + 1;
      }
    }
    for (let i = 0; i < this.early; i++) opaque[i].plain = opaque[i].splits = false;
  }

  /** @param reversed - whether the sorted lists are reversed, as three until 0.185 does for reversed depth */
  sort(opaque: RenderItemSort | null, transparent: RenderItemSort | null, reversed: boolean): void {
    if (this.opaque.length > 1) this.opaque.sort(opaque ?? byState);
    if (this.transmissive.length > 1) this.transmissive.sort(transparent ?? backToFront);
    if (this.transparent.length > 1) this.transparent.sort(transparent ?? backToFront);
    if (!reversed) return;
    this.opaque.reverse();
    this.transmissive.reverse();
    this.transparent.reverse();
  }
}
