import { type BufferGeometry, type Camera, Material, type Object3D, type ShaderMaterial, Vector3 } from 'three';
import { isOrderSensitive, isPlainOpaque } from '../three/drawOrder';
import { hasNodes } from '../three/hasNodes';
import { isLit } from '../materials/isLit';
import { isGouraud } from '../materials/shadingOf';
import { RefusedMaterials } from '../materials/RefusedMaterials';
import { threeChunks } from '../three/ThreeChunks';
import type { TwinKind } from '../materials/TwinKind';
import { isStepOfHost } from './hostCallbacks';
import { isPlain, type ItemShading, type RenderItem } from './RenderItem';
import type { GeometryGroup, RenderItemSort, RenderListItem } from '../three/RenderListItem';
import type { DirectDraw } from '../three/directDraw';
import { warnOfNaN } from './warnOfNaN';

const center = new Vector3();

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
function backToFront(a: RenderListItem, b: RenderListItem): number {
  return a.groupOrder - b.groupOrder || a.renderOrder - b.renderOrder || b.z - a.z || a.id - b.id;
}

/** Whether a material has another shader than three's for its class. */
export function hasOwnShader(material: Material): boolean {
  return (
    (material as ShaderMaterial).isShaderMaterial === true ||
    material.onBeforeCompile !== Material.prototype.onBeforeCompile
  );
}

/** Test for materials that show shadows by three's `getShadowMask()`, and the twin kind that shows Farol's. */
export interface ShadowMaskMaterials {
  shows(material: Material): boolean;
  readonly twin: TwinKind;
}

/** Properties of a material, as read in the frame with the number `frame`. */
interface MaterialLook {
  frame: number;
  ownShader: boolean;
  shading: ItemShading;
  isPlainOpaque: boolean;
  isOrderSensitive: boolean;
}

/** Order of a scene's materials in which those that hide others come first. */
export interface MaterialOrder {
  /** Id of the first material; materials of lower ids come after some of higher ids. */
  readonly pivot: number;
  /** Draws as `Frame.draw`, but with LessDepth in place of LessEqualDepth: for items below the pivot. */
  readonly draw: DirectDraw;
  /** @returns opaque items, valid until the next call; null if they must be drawn in three's order */
  sort(queue: OpaqueItems): readonly RenderItem[] | null;
}

/** Parts of a RenderQueue that orders of materials read. */
export type OpaqueItems = Pick<RenderQueue, 'cleared' | 'reaches'> & { readonly opaque: readonly RenderItem[] };

/** Draws of a frame, in three.js's three lists. Items are pooled. */
export class RenderQueue {
  readonly opaque: RenderItem[] = [];
  readonly transmissive: RenderItem[] = [];
  readonly transparent: RenderItem[] = [];
  private readonly pool: RenderItem[] = [];
  /** Layers of items that are not `layered`; 0 when lights ignore layers. */
  layers = 0;
  /** Twins of materials that show only shadows (ShadowMaterial); null while three draws them. Set by `FrameLights.update`. */
  shadowMasks: ShadowMaskMaterials | null = null;
  /** True if every opaque item is plain, and its material writes the geometry's depth. */
  covers = true;
  /** True if an opaque object may be so far away that its depth equals the cleared depth, see `watchFar`. */
  reachesFar = false;
  /** Order of materials for passes that draw opaque items once; null for three's. */
  order: MaterialOrder | null = null;
  /** Whether three's default order was asked for, and no item's picture depends on it. */
  private mayReorder = false;
  /** Items whose material has a lower id are hidden by surfaces of equal depth, see `beginOrder`; 0 for none. */
  pivot = 0;
  private camera!: Camera;
  /** Distance (m) given to `watchFar`. */
  cleared = Infinity;
  /** Distance (m) from which on depth equals the cleared depth; -Infinity if depth gives no distance. */
  farthest = Infinity;
  /** Materials that only three's own lights can light. */
  readonly refused = new RefusedMaterials();
  /** Number of opaque items, from the first on, that are drawn into the target before anything else. */
  early = 0;
  /** True if an opaque item must be drawn in three's order. */
  ordered = false;
  /** True if a lit object is transmissive or transparent. */
  hasLitTransparents = false;
  /** Material of the frame's last item, whose properties are cached; null before the first. */
  private material: Material | null = null;
  private materialLook!: MaterialLook;
  /** Properties of materials; those of earlier frames are read again. */
  private readonly materialLooks = new WeakMap<Material, MaterialLook>();
  private frame = 0;
  private used = 0;
  private opaques = 0;
  private transmissives = 0;
  private transparents = 0;

  clear(): void {
    this.used = 0;
    this.frame++;
    this.material = null;
    this.covers = true;
    this.ordered = this.mayReorder = false;
    this.pivot = 0;
    this.early = 0;
    this.reachesFar = this.farthest === -Infinity;
    this.hasLitTransparents = false;
    this.opaques = this.transmissives = this.transparents = 0;
  }

  /** Tests opaque items, from the next `clear` on, for objects beyond a distance along the view (m). */
  watchFar(camera: Camera, distance: number): void {
    this.camera = camera;
    this.farthest = this.cleared = distance;
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
    if (material !== this.material) this.lookAt(material);
    const { isOrderSensitive, isPlainOpaque, ownShader, shading } = this.materialLook;
    const lit = shading === 'lit';
    item.shading = shading;
    item.ownShader = ownShader;
    const isStep = isStepOfHost(object, groupOrder !== 0 || object.renderOrder !== 0);
    if (list !== this.opaque) item.route = 'forward';
    else if (!isStep && isPlainOpaque) item.route = lit && !ownShader ? 'split' : 'plain';
    else item.route = isStep || isOrderSensitive ? 'ordered' : 'forward';
    item.layered = this.layers !== 0 && object.layers.mask !== this.layers;
    item.drawn = false;
    if (list === this.opaque) {
      // a polygon offset shifts depth, so positions cannot be computed from it
      if (material.polygonOffset) this.farthest = -Infinity;
      if (!this.reachesFar && this.farthest !== Infinity)
        this.reachesFar = this.reaches(object, geometry, this.farthest);
    }
    if (lit && list !== this.opaque) this.hasLitTransparents = true;
    if (list === this.opaque && (!isPlain(item) || ownShader)) this.covers = false;
    if (item.route === 'ordered') this.ordered = true;
    // `finish` sets the lists' lengths, so that they keep their storage
    if (list === this.opaque) list[this.opaques++] = item;
    else if (list === this.transparent) list[this.transparents++] = item;
    else list[this.transmissives++] = item;
  }

  /** Reads the properties of the next items' material, once a frame: no host code runs between items. */
  private lookAt(material: Material): void {
    let look = this.materialLooks.get(material);
    if (look === undefined) this.materialLooks.set(material, (look = {} as MaterialLook));
    if (look.frame !== this.frame) {
      const nodes = hasNodes(material);
      const ownShader = nodes || threeChunks.shading || hasOwnShader(material) || isGouraud(material);
      const shading = nodes ? 'nodes' : this.shadingOf(material, ownShader);
      if (ownShader && shading !== 'lit' && !nodes && (material as ShaderMaterial).lights === true)
        this.refused.check(material as ShaderMaterial);
      look.frame = this.frame;
      look.ownShader = ownShader;
      look.shading = shading;
      look.isPlainOpaque = isPlainOpaque(material);
      look.isOrderSensitive = isOrderSensitive(material);
    }
    this.material = material;
    this.materialLook = look;
  }

  /** Shading of an item without nodes. @param ownShader - whether its shader differs from three's */
  private shadingOf(material: Material, ownShader: boolean): ItemShading {
    const lit = !threeChunks.lights && isLit(material);
    if (!lit && this.shadowMasks?.shows(material) !== true) return 'unlit';
    if (ownShader && this.refused.has(material)) return 'unlit';
    return lit ? 'lit' : 'shadow-mask';
  }

  /** Whether an object's bounding sphere extends beyond a distance (m). True without a sphere. */
  reaches(object: Object3D, geometry: BufferGeometry, distance: number): boolean {
    const sphere = (object as Object3D & Partial<BufferGeometry>).boundingSphere ?? geometry.boundingSphere;
    if (sphere === null || !object.frustumCulled) return true;
    const { matrixWorld } = object;
    const { z } = center.copy(sphere.center).applyMatrix4(matrixWorld).applyMatrix4(this.camera.matrixWorldInverse);
    return !(sphere.radius * matrixWorld.getMaxScaleOnAxis() - z <= distance);
  }

  /** Ends the lists, and drops references to objects of earlier, larger frames. */
  finish(): void {
    this.material = null;
    this.opaque.length = this.opaques;
    this.transmissive.length = this.transmissives;
    this.transparent.length = this.transparents;
    for (let i = this.used; i < this.pool.length && this.pool[i].object !== null; i++) {
      const item = this.pool[i] as { -readonly [K in keyof RenderItem]: RenderItem[K] | null };
      item.object = item.geometry = item.material = item.group = null;
    }
  }

  /**
   * Keeps three's order where it is visible. Items up to the last 'ordered' one are drawn early, as long as no 'split' item
   * comes before; once a 'split' item precedes an 'ordered' one, plain items after that are drawn by the forward pass.
   */
  keepOrder(): void {
    if (!this.ordered) return;
    const { opaque } = this;
    let split = false;
    let behind = false;
    for (let i = 0; i < opaque.length; i++) {
      const item = opaque[i];
      if (isPlain(item)) {
        if (behind) item.route = 'forward';
        else if (item.route === 'split') split = true;
      } else if (item.route === 'ordered') {
        if (split) behind = true;
        else this.early = i + 1;
      }
    }
    for (let i = 0; i < this.early; i++) if (isPlain(opaque[i])) opaque[i].route = 'forward';
  }

  /**
   * Begins draws of opaque items, each once, over depth that no item has written. Set `pivot` to 0 after them. three shows the
   * item drawn last of those at one depth, which is that of the highest material id; an item below the pivot comes after
   * items of higher ids alone, and must be hidden by them: `Frame.drawItem` draws it by LessDepth.
   * @returns items in the order in which to draw them
   */
  beginOrder(): readonly RenderItem[] {
    const { opaque, order } = this;
    const items = this.mayReorder && order !== null ? order.sort(this) : null;
    if (items === null) return opaque;
    this.pivot = order!.pivot;
    return items;
  }

  /** @param reversed - whether to reverse the sorted lists, as three up to 0.185 does for reversed depth */
  sort(opaque: RenderItemSort | null, transparent: RenderItemSort | null, reversed: boolean): void {
    this.mayReorder = opaque === null && !reversed && !this.ordered;
    if (this.opaque.length > 1) this.opaque.sort((opaque as typeof byState | null) ?? byState);
    if (this.transmissive.length > 1) this.transmissive.sort(transparent ?? backToFront);
    if (this.transparent.length > 1) this.transparent.sort(transparent ?? backToFront);
    if (!reversed) return;
    this.opaque.reverse();
    this.transmissive.reverse();
    this.transparent.reverse();
  }
}
