import { type Camera, type InstancedMesh, type LOD, type Mesh, type Object3D, Sphere } from 'three';
import type { Caster } from './Caster';
import { casterBox } from './casterBox';
import { casterSignature, isAnimatedCaster } from './casterSignature';
import { hasReadableVertices, isReadable } from '../../three/vertexData';

const sphere = new Sphere();

/**
 * The objects of one scene that cast shadows, and where any of them has changed since the last frame: spheres around old and new
 * positions. Traverses the scene once a frame; allocates only for new casters.
 */
export class ShadowCasters {
  readonly list: Caster[] = [];
  count = 0;
  /** Objects that receive shadows but cast none. */
  readonly receivers: Object3D[] = [];
  /** World-space spheres (m) in which some caster has changed, 4 numbers each; the first `changeCount` are valid. */
  changes = new Float64Array(64);
  changeCount = 0;
  private readonly known = new WeakMap<Object3D, Caster>();
  private previous: Caster[] = [];
  /** Number of traversals of the scene so far. */
  walks = 0;
  walked: Object3D | null = null;
  private receiversCast = false;

  /**
   * Traverses the scene.
   * @param camera - camera by which LODs choose their level
   * @param receiversCast - true for variance shadow maps, into which three draws objects that receive shadows too
   */
  update(root: Object3D, camera: Camera, receiversCast: boolean): void {
    this.walks++;
    this.walked = root;
    const { list } = this;
    for (let i = 0; i < this.count; i++) this.previous[i] = list[i];
    const before = this.count;
    this.count = this.changeCount = this.receivers.length = 0;
    this.receiversCast = receiversCast;
    if (root.visible) this.visit(root, camera);
    list.length = this.count;
    for (let i = 0; i < before; i++) {
      const caster = this.previous[i];
      if (caster.lastWalk !== this.walks) this.addChange(caster);
    }
    this.previous.length = before;
  }

  private visit(object: Object3D, camera: Camera): void {
    const mesh = object as Mesh & { isLine?: boolean; isPoints?: boolean; isLOD?: boolean };
    if (mesh.isMesh || mesh.isLine || mesh.isPoints) {
      if (object.castShadow || (this.receiversCast && object.receiveShadow)) this.meet(object);
      else if (object.receiveShadow) this.receivers.push(object);
    } else if (mesh.isLOD && (object as LOD).autoUpdate && object.layers.test(camera.layers)) {
      (object as LOD).update(camera);
    }
    const { children } = object;
    for (let i = 0; i < children.length; i++) if (children[i].visible) this.visit(children[i], camera);
  }

  private meet(object: Object3D): void {
    const { geometry, material } = object as Partial<Mesh>;
    if (!geometry || !material) return; // three reports what is missing when it draws the object
    let caster = this.known.get(object);
    if (caster === undefined) {
      caster = makeCaster(object);
      this.known.set(object, caster);
    }
    const signature = casterSignature(object);
    // an object that the last traversal did not find is new
    let changes = caster.lastWalk !== this.walks - 1 || signature !== caster.signature || isAnimatedCaster(object);
    const was = caster.matrix;
    const { elements } = object.matrixWorld;
    let hasMoved = false;
    for (let i = 0; i < 16; i++) {
      if (was[i] === elements[i]) continue;
      was[i] = elements[i];
      hasMoved = true;
    }
    changes ||= hasMoved;
    if (changes) {
      if (caster.lastWalk === this.walks - 1) this.addChange(caster);
      findSphere(object, caster);
      caster.hasBox = caster.radius !== Infinity && casterBox(object, caster.box);
      if (signature !== caster.signature) {
        caster.signatureVersion++;
        caster.signatureWalk = this.walks;
      }
      caster.signature = signature;
      caster.matrixVersion++;
      this.addChange(caster);
    }
    caster.lastWalk = this.walks;
    this.list[this.count++] = caster;
  }

  private addChange(caster: Caster): void {
    const at = this.changeCount * 4;
    if (at + 4 > this.changes.length) {
      const more = new Float64Array(this.changes.length * 2);
      more.set(this.changes);
      this.changes = more;
    }
    this.changes[at] = caster.x;
    this.changes[at + 1] = caster.y;
    this.changes[at + 2] = caster.z;
    this.changes[at + 3] = caster.radius;
    this.changeCount++;
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
    lastWalk: -1,
    proxy: null,
    proxyFrame: -1,
    matrixVersion: 0,
    signatureVersion: 0,
    signatureWalk: 0,
    merged: null,
    queuedVersion: -1,
  };
}

/**
 * Finds the world-space sphere (m) that three culls an object by; radius Infinity where three does not cull, or where the CPU
 * cannot read the vertices and no sphere is set.
 */
export function findSphere(object: Object3D, caster: Pick<Caster, 'x' | 'y' | 'z' | 'radius'>): void {
  const mesh = object as InstancedMesh;
  const bounded: Pick<Mesh['geometry'], 'boundingSphere' | 'computeBoundingSphere'> =
    mesh.boundingSphere === undefined ? mesh.geometry : mesh;
  if (object.frustumCulled && bounded.boundingSphere === null && isMeasurable(mesh)) bounded.computeBoundingSphere();
  if (!object.frustumCulled || !Number.isFinite(bounded.boundingSphere?.radius)) {
    caster.radius = Infinity;
    return;
  }
  sphere.copy(bounded.boundingSphere!).applyMatrix4(object.matrixWorld);
  caster.x = sphere.center.x;
  caster.y = sphere.center.y;
  caster.z = sphere.center.z;
  caster.radius = sphere.radius;
}

function isMeasurable({ geometry, instanceMatrix }: InstancedMesh): boolean {
  return hasReadableVertices(geometry) && (instanceMatrix === undefined || isReadable(instanceMatrix));
}
