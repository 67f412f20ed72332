import {
  type BatchedMesh,
  DataTexture,
  FloatType,
  type InstancedMesh,
  type Material,
  type Matrix4,
  type Mesh,
  type Object3D,
  RGBAFormat,
  type SkinnedMesh,
} from 'three';
import { surfacesOf } from '../../materials/surfacesOf';
import { batchMatrices } from '../../three/batchTextures';
import { attributeState } from '../../three/vertexData';

/** Number of instance matrices in a row of a texture, four texels each. */
const INSTANCES_PER_ROW = 512;

/** State of an object in the last frame: its matrix, bones, morphs and instances. */
export class ObjectMotion {
  /** Number of the frame in which the state was copied. */
  frame = -1;
  /** Whether the object moved in the frame whose state is copied, compared with the frame before that one. */
  moves = false;
  /** World matrix; for a skinned mesh times the inverse of its bind matrix. */
  readonly matrix = new Float64Array(16);
  /** Texture of a skinned mesh's bone matrices in the last frame; null for other objects. */
  bones: DataTexture | null = null;
  /** Instance matrices of the copied state; null until the matrices first change. */
  instances: DataTexture | null = null;
  morphBase = 1;
  morphs: number[] = [];
  /** Whether the object is in `ObjectMotions.holders`, whose textures must be freed. */
  listed = false;
  /** Times (s) of the surface shaders that displace the object's vertices. */
  readonly surfaceTimes: number[] = [];
  private surfaces = 0;
  private instancesVersion = -1;
  /** Version of the vertices in the last frame, see `verticesOf`. */
  private vertices = 0;

  /** Whether the object has moved since the last `remember`. */
  hasMoved(object: Object3D): boolean {
    worldOf(object, world);
    for (let i = 0; i < 16; i++) if (world[i] !== this.matrix[i]) return true;
    const { morphTargetInfluences } = object as Mesh;
    if (morphTargetInfluences !== undefined) {
      for (let i = 0; i < morphTargetInfluences.length; i++) {
        if (morphTargetInfluences[i] !== this.morphs[i]) return true;
      }
    }
    if (this.bones !== null) {
      const now = (object as SkinnedMesh).skeleton.boneMatrices!;
      const before = this.bones.image.data as unknown as Float32Array;
      for (let i = 0; i < now.length; i++) if (now[i] !== before[i]) return true;
    }
    if (displacementOf(object) !== this.surfaces || verticesOf(object) !== this.vertices) return true;
    return instancesOf(object) !== null && versionOf(object) !== this.instancesVersion;
  }

  /**
   * Whether the former state is known; false if the page has changed vertices. Matrices of instances are known from their first
   * change on.
   */
  isKnown(object: Object3D): boolean {
    if (verticesOf(object) !== this.vertices) return false;
    const now = instancesOf(object);
    if (now === null || this.instances !== null) return true;
    if (versionOf(object) !== this.instancesVersion) return false;
    this.copyInstances(object, now);
    return true;
  }

  /** Copies the object's matrix, bones and morphs, for the next frame to compare with. */
  remember(object: Object3D, frame: number): void {
    this.frame = frame;
    worldOf(object, this.matrix);
    const mesh = object as SkinnedMesh;
    if (mesh.morphTargetInfluences !== undefined) {
      let sum = 0;
      for (let i = 0; i < mesh.morphTargetInfluences.length; i++) {
        this.morphs[i] = mesh.morphTargetInfluences[i];
        sum += this.morphs[i];
      }
      this.morphBase = mesh.geometry.morphTargetsRelative ? 1 : 1 - sum;
    }
    if (mesh.isSkinnedMesh === true && mesh.skeleton.boneMatrices !== null) {
      const { boneMatrices, boneTexture } = mesh.skeleton;
      const size = boneTexture?.image.width ?? 4;
      if (this.bones === null || this.bones.image.data!.length !== boneMatrices.length) {
        this.bones?.dispose();
        this.bones = matrixTexture(new Float32Array(boneMatrices.length), size);
      }
      (this.bones.image.data as unknown as Float32Array).set(boneMatrices);
      this.bones.needsUpdate = true;
    }
    this.surfaces = displacementOf(object);
    this.vertices = verticesOf(object);
    if (this.surfaces !== 0) copyTimes(object, this.surfaceTimes);
    this.rememberInstances(object);
  }

  /** Whether the object's remembered state (bones, instances) has textures. */
  get holds(): boolean {
    return this.bones !== null || this.instances !== null;
  }

  /** Frees the textures, and forgets their contents. */
  dispose(): void {
    this.bones?.dispose();
    this.instances?.dispose();
    this.bones = this.instances = null;
    this.instancesVersion = -1;
    this.listed = false;
  }

  private rememberInstances(object: Object3D): void {
    const now = instancesOf(object);
    if (now === null) return;
    const version = versionOf(object);
    const first = this.instancesVersion === -1;
    if (version === this.instancesVersion) return;
    this.instancesVersion = version;
    if (!first) this.copyInstances(object, now);
  }

  private copyInstances(object: Object3D, now: Float32Array): void {
    const batch = (object as BatchedMesh).isBatchedMesh === true;
    const width = batch ? Math.sqrt(now.length / 4) : 4 * INSTANCES_PER_ROW;
    const length = batch ? now.length : Math.ceil(now.length / (16 * INSTANCES_PER_ROW)) * 16 * INSTANCES_PER_ROW;
    if (this.instances === null || this.instances.image.data!.length !== length) {
      this.instances?.dispose();
      this.instances = matrixTexture(new Float32Array(length), width);
    }
    (this.instances.image.data as unknown as Float32Array).set(now);
    this.instances.needsUpdate = true;
  }
}

const world = new Float64Array(16);

/** Number that changes when an object's surface shaders displace vertices differently; 0 if none displaces. */
function displacementOf(object: Object3D): number {
  const { material } = object as Mesh;
  if (Array.isArray(material)) {
    let sum = 0;
    for (let i = 0; i < material.length; i++) sum += displacementOfOne(material[i]);
    return sum;
  }
  return material === undefined ? 0 : displacementOfOne(material);
}

/** Copies the animation times (s) of an object's GLSL surfaces; with several materials, those of the last. */
function copyTimes(object: Object3D, times: number[]): void {
  const { material } = object as Mesh;
  if (!Array.isArray(material)) surfacesOf(material)?.copyTimes(times);
  else for (let i = 0; i < material.length; i++) surfacesOf(material[i])?.copyTimes(times);
}

function displacementOfOne(material: Material): number {
  const surfaces = surfacesOf(material);
  return surfaces?.displaces === true ? surfaces.shapeVersion() + 1 : 0;
}

function worldOf(object: Object3D, out: Float64Array): void {
  const skinned = object as SkinnedMesh;
  if (skinned.isSkinnedMesh === true) multiply(object.matrixWorld, skinned.bindMatrixInverse, out);
  else out.set(object.matrixWorld.elements);
}

function multiply(a: Matrix4, b: Matrix4, out: Float64Array): void {
  const x = a.elements;
  const y = b.elements;
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += x[row + 4 * k] * y[k + 4 * column];
      out[row + 4 * column] = sum;
    }
  }
}

function instancesOf(object: Object3D): Float32Array | null {
  if ((object as InstancedMesh).isInstancedMesh === true) {
    return (object as InstancedMesh).instanceMatrix.array as Float32Array;
  }
  if ((object as BatchedMesh).isBatchedMesh === true) {
    return batchMatrices(object as BatchedMesh).image.data as unknown as Float32Array;
  }
  return null;
}

/** Number that changes when the page changes an object's vertices or the morphs of its instances. */
function verticesOf(object: Object3D): number {
  const { geometry, morphTexture } = object as InstancedMesh;
  const { position } = geometry.attributes;
  const vertices = position === undefined ? 0 : attributeState(position);
  return morphTexture ? vertices + (morphTexture.id * 65_536 + morphTexture.version) * 7 : vertices;
}

function versionOf(object: Object3D): number {
  if ((object as InstancedMesh).isInstancedMesh === true)
    return attributeState((object as InstancedMesh).instanceMatrix);
  const { id, version } = batchMatrices(object as BatchedMesh);
  return id * 65_536 + version;
}

function matrixTexture(data: Float32Array<ArrayBuffer>, width: number): DataTexture {
  return new DataTexture(data, width, data.length / 4 / width, RGBAFormat, FloatType);
}
