import { type Camera, type LOD, type Mesh, type Object3D, Sphere } from 'three';
import { sphereOutsidePlanes } from '../../../lights/sphereOutsidePlanes';
import { boxOutsidePlanes, casterBox } from './casterBox';
import { casterSignature, isAnimatedCaster } from './casterSignature';
import type { MergedCaster } from './merged';
import type { ShadowFace } from '../slots/ShadowFace';
import type { ShadowSlot } from '../slots/ShadowSlot';

/** One object that casts shadows, as it was when it was last seen. */
export interface Caster {
  readonly object: Object3D;
  /** World-space bounding sphere: centre, radius (m); radius Infinity where the object is not to be culled. */
  x: number;
  y: number;
  z: number;
  radius: number;
  /** Box along the world's axes, as `casterBox` gives it, where there is one. */
  readonly box: Float64Array;
  hasBox: boolean;
  readonly matrix: Float64Array;
  signature: number;
  frame: number;
  /** What three is given to bring its buffers up to date, see SceneView. */
  stand: Object3D | null;
  /** Counts the places that it was in, and the looks that it had; and the frame since which it has the last. */
  place: number;
  look: number;
  looked: number;
  /** Among the merged casters; and the look that it was last to be merged with, -1 for none. */
  merged: MergedCaster | null;
  waits: number;
  /** The frame for which `stand` was handed out. */
  prepared: number;
}

const sphere = new Sphere();

/**
 * The objects of one scene that cast shadows, and where any of them changed since the last frame: spheres round the old
 * and the new places. One walk over the scene a frame, no allocation while nothing new comes.
 */
export class ShadowCasters {
  readonly list: Caster[] = [];
  count = 0;
  /** What receives shadows but casts none. */
  readonly receivers: Object3D[] = [];
  /** World-space spheres where something changed, 4 numbers each. */
  changes = new Float64Array(64);
  changed = 0;
  private readonly known = new WeakMap<Object3D, Caster>();
  private previous: Caster[] = [];
  /** Counts the updates. */
  frame = 0;
  private receiversCast = false;

  /**
   * @param receiversCast true for variance shadow maps, into which three draws what receives shadows too
   * @param camera which levels of detail are seen
   */
  update(root: Object3D, camera: Camera, receiversCast: boolean): void {
    this.frame++;
    const { list } = this;
    for (let i = 0; i < this.count; i++) this.previous[i] = list[i];
    const before = this.count;
    this.count = this.changed = this.receivers.length = 0;
    this.receiversCast = receiversCast;
    if (root.visible) this.visit(root, camera);
    list.length = this.count;
    for (let i = 0; i < before; i++) {
      const caster = this.previous[i];
      if (caster.frame !== this.frame) this.addChange(caster);
    }
    this.previous.length = before;
  }

  private visit(object: Object3D, camera: Camera): void {
    const mesh = object as Mesh & { isLine?: boolean; isPoints?: boolean; isLOD?: boolean };
    if (mesh.isMesh || mesh.isLine || mesh.isPoints) {
      if (object.castShadow || (this.receiversCast && object.receiveShadow)) this.see(object);
      else if (object.receiveShadow) this.receivers.push(object);
    } else if (mesh.isLOD && (object as LOD).autoUpdate && object.layers.test(camera.layers)) {
      (object as LOD).update(camera);
    }
    const { children } = object;
    for (let i = 0; i < children.length; i++) if (children[i].visible) this.visit(children[i], camera);
  }

  private see(object: Object3D): void {
    const { geometry, material } = object as Partial<Mesh>;
    if (!geometry || !material) return; // three says what is wrong, if it draws the object at all
    let caster = this.known.get(object);
    if (caster === undefined) {
      caster = makeCaster(object);
      this.known.set(object, caster);
    }
    const signature = casterSignature(object);
    // what was not there in the last frame comes as new
    let moved = caster.frame !== this.frame - 1 || signature !== caster.signature || isAnimatedCaster(object);
    const was = caster.matrix;
    const { elements } = object.matrixWorld;
    let placed = false;
    for (let i = 0; i < 16; i++) {
      if (was[i] === elements[i]) continue;
      was[i] = elements[i];
      placed = true;
    }
    moved ||= placed;
    if (moved) {
      if (caster.frame === this.frame - 1) this.addChange(caster);
      findSphere(object, caster);
      caster.hasBox = caster.radius !== Infinity && casterBox(object, caster.box);
      if (signature !== caster.signature) {
        caster.look++;
        caster.looked = this.frame;
      }
      caster.signature = signature;
      caster.place++;
      this.addChange(caster);
    }
    caster.frame = this.frame;
    this.list[this.count++] = caster;
  }

  private addChange(caster: Caster): void {
    const at = this.changed * 4;
    if (at + 4 > this.changes.length) {
      const more = new Float64Array(this.changes.length * 2);
      more.set(this.changes);
      this.changes = more;
    }
    this.changes[at] = caster.x;
    this.changes[at + 1] = caster.y;
    this.changes[at + 2] = caster.z;
    this.changes[at + 3] = caster.radius;
    this.changed++;
  }
}

function makeCaster(object: Object3D): Caster {
  return {
    object,
    x: 0,
    y: 0,
    z: 0,
    radius: Infinity,
    box: new Float64Array(6),
    hasBox: false,
    matrix: new Float64Array(16).fill(NaN),
    signature: 0,
    frame: -1,
    stand: null,
    place: 0,
    look: 0,
    looked: 0,
    merged: null,
    waits: -1,
    prepared: -1,
  };
}

/** The sphere that three culls the object by, in world space; radius Infinity where it does not. */
export function findSphere(object: Object3D, caster: Pick<Caster, 'x' | 'y' | 'z' | 'radius'>): void {
  const mesh = object as Mesh & { boundingSphere?: Sphere | null; computeBoundingSphere?: () => void };
  if (!object.frustumCulled) {
    caster.radius = Infinity;
    return;
  }
  if (mesh.boundingSphere !== undefined) {
    if (mesh.boundingSphere === null) mesh.computeBoundingSphere?.();
    sphere.copy(mesh.boundingSphere!);
  } else {
    if (mesh.geometry.boundingSphere === null) mesh.geometry.computeBoundingSphere();
    sphere.copy(mesh.geometry.boundingSphere!);
  }
  sphere.applyMatrix4(object.matrixWorld);
  caster.x = sphere.center.x;
  caster.y = sphere.center.y;
  caster.z = sphere.center.z;
  caster.radius = sphere.radius;
}

/** True when a light's maps may show the caster at all. */
export function isReached(caster: Caster, slot: ShadowSlot): boolean {
  if ((caster.object.layers.mask & slot.layers) === 0) return false;
  const { x, y, z, radius, hasBox, box } = caster;
  return slot.reaches(x, y, z, radius) && (!hasBox || slot.reachesBox(box));
}

/** True when a face of the maps may see a caster that is reached, in the part of it that is drawn. */
export function isSeen({ x, y, z, radius, hasBox, box }: Caster, face: ShadowFace): boolean {
  if (face.texels === 0) return false;
  if (radius === Infinity) return true;
  const planes = face.drawnPlanes;
  return !sphereOutsidePlanes(planes, x, y, z, radius) && !(hasBox && boxOutsidePlanes(planes, box));
}
