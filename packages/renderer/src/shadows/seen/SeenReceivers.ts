import { type Camera, Matrix4, type Object3D } from 'three';
import { viewFrustumPlanes } from '../../lights/viewFrustumPlanes';
import { boxOutsidePlanes, casterBox } from '../casterBox';
import { CLUSTERS_PER_GROUP, type MergedCasters } from '../merged';
import { type Caster, findSphere, type ShadowCasters } from '../ShadowCasters';
import { isBeyond, makeReach, setReach } from '../reach';
import type { ShadowFace } from '../ShadowFace';
import type { ShadowSlot } from '../ShadowSlot';
import { cubeFaceParts } from './cubeFaceParts';
import { mapPart } from './mapPart';

/** How much wider than the camera's the view is that counts: cameras that shake by a part of a pixel see no more. */
const WIDER = 1.01;
/** What bends in shaders may leave its sphere by as much. */
const SPHERES = 2;
/** Numbers of a group: its box, the index of its first box and that after its last. */
const GROUP = 8;

const matrix = new Matrix4();
const planes = new Float64Array(24);
const parts = new Float64Array(24);
const reach = makeReach();
const sphere = { x: 0, y: 0, z: 0, radius: 0 };

/**
 * Where in the view of a camera shadows can be seen: boxes round what receives them. While something moves, a map is drawn
 * only where that is, by `cut`.
 */
export class SeenReceivers {
  /** Boxes along the world's axes: centre and half sizes (m), 6 numbers each. */
  private boxes = new Float64Array(6 * 256);
  private used = 0;
  /** Boxes that lie together, and the box round them, see `GROUP`. */
  private groups = new Float64Array(GROUP * 64);
  private count = 0;
  /** Something may be anywhere. */
  private isUnbounded = false;

  /**
   * Finds them for a frame.
   * @param merged those of the casters, ready for the frame
   */
  find({ list, count, receivers }: ShadowCasters, merged: MergedCasters | null, camera: Camera): void {
    this.used = this.count = 0;
    this.isUnbounded = false;
    matrix.copy(camera.projectionMatrix);
    const e = matrix.elements;
    for (let column = 0; column < 16; column += 4) {
      e[column] /= WIDER;
      e[column + 1] /= WIDER;
    }
    viewFrustumPlanes(matrix.multiply(camera.matrixWorldInverse).elements, planes);
    for (let i = 0; i < count; i++) {
      const { object } = list[i];
      if (object.receiveShadow && object.layers.test(camera.layers)) this.addCaster(list[i], merged);
    }
    for (const object of receivers) if (object.layers.test(camera.layers)) this.addObject(object);
  }

  /**
   * Finds which part of each face of a light's map can be seen, with what filters read beside it.
   * @returns false where that is all, or not known
   */
  cut(slot: ShadowSlot): boolean {
    if (this.isUnbounded) return false;
    const { faces, isCube, light, faceWidth, faceHeight } = slot;
    const { radius, normalBias } = light.shadow;
    const texels = Math.ceil(2 * radius) + 2;
    // along its normal, a surface looks up the map that far from where it is
    const shift = Math.abs(normalBias);
    for (let i = 0; i < 24; i += 2) {
      parts[i] = Infinity;
      parts[i + 1] = -Infinity;
    }
    if (!isCube) {
      for (const face of faces)
        face.matrix.multiplyMatrices(face.camera.projectionMatrix, face.camera.matrixWorldInverse);
    }
    const place = faces[0].camera.matrixWorld.elements;
    setReach(reach, place, slot.range + shift, 1 + (2 * texels) / faceWidth, shift);
    const { boxes, groups } = this;
    for (let group = 0; group < this.count * GROUP; group += GROUP) {
      if (isBeyond(reach, groups, group)) continue;
      const wide = isCube ? cubeFaceParts(parts, groups, group, reach, false) : 0;
      if (wide === 1) cubeFaceParts(parts, groups, group, reach);
      let widens = wide === 2;
      for (let i = isCube ? 6 : 0; i < faces.length && !widens; i++) {
        widens = mapPart(parts, i * 4, groups, group, reach, faces[i].matrix, false);
      }
      if (!widens) continue;
      for (let at = groups[group + 6]; at < groups[group + 7]; at += 6) {
        if (isBeyond(reach, boxes, at)) continue;
        if (isCube) cubeFaceParts(parts, boxes, at, reach);
        else for (let i = 0; i < faces.length; i++) mapPart(parts, i * 4, boxes, at, reach, faces[i].matrix);
      }
    }
    let all = true;
    for (let i = 0; i < faces.length; i++) {
      setPart(faces[i], i * 4, faceWidth, faceHeight, slot.border, texels);
      all &&= isWhole(faces[i]);
    }
    return !all;
  }

  private addCaster({ merged, hasBox, box, x, y, z, radius }: Caster, all: MergedCasters | null): void {
    if (merged === null) {
      if (hasBox) this.addBox(box);
      else this.addSphere(x, y, z, radius);
      return;
    }
    if (boxOutsidePlanes(planes, box)) return;
    all!.follow(merged);
    const { boxes, groups } = merged;
    for (let group = 0; group < groups.length; group += 6) {
      if (boxOutsidePlanes(planes, groups, group)) continue;
      const first = this.used;
      const end = Math.min(boxes.length, (group + 6) * CLUSTERS_PER_GROUP);
      for (let at = group * CLUSTERS_PER_GROUP; at < end; at += 6) {
        if (!boxOutsidePlanes(planes, boxes, at)) this.push(boxes, at);
      }
      if (this.used > first) this.addGroup(first, groups, group);
    }
  }

  private addObject(object: Object3D): void {
    if (casterBox(object, own)) {
      this.addBox(own);
      return;
    }
    findSphere(object, sphere);
    this.addSphere(sphere.x, sphere.y, sphere.z, sphere.radius);
  }

  private addSphere(x: number, y: number, z: number, radius: number): void {
    if (!Number.isFinite(x + y + z + radius)) {
      this.isUnbounded = true;
      return;
    }
    own[0] = x;
    own[1] = y;
    own[2] = z;
    own[3] = own[4] = own[5] = SPHERES * radius;
    this.addBox(own);
  }

  private addBox(box: Float64Array): void {
    if (boxOutsidePlanes(planes, box)) return;
    this.push(box, 0);
    this.addGroup(this.used - 6, box, 0);
  }

  private push(boxes: Float64Array, at: number): void {
    if (this.used + 6 > this.boxes.length) this.boxes = grown(this.boxes);
    for (let i = 0; i < 6; i++) this.boxes[this.used + i] = boxes[at + i];
    this.used += 6;
  }

  /**
   * @param first index of its first box; the others follow
   * @param round box round them, in it from index `from` on
   */
  private addGroup(first: number, round: Float64Array, from: number): void {
    const at = this.count * GROUP;
    if (at + GROUP > this.groups.length) this.groups = grown(this.groups);
    for (let i = 0; i < 6; i++) this.groups[at + i] = round[from + i];
    this.groups[at + 6] = first;
    this.groups[at + 7] = this.used;
    this.count++;
  }
}

const own = new Float64Array(6);

function grown(numbers: Float64Array): Float64Array<ArrayBuffer> {
  const more = new Float64Array(numbers.length * 2);
  more.set(numbers);
  return more;
}

/** Sets a face's part, in texels of what it draws to, from `parts`. */
function setPart(face: ShadowFace, at: number, width: number, height: number, border: number, texels: number): void {
  const { part } = face;
  const nothing = parts[at] > parts[at + 1];
  part.left = nothing ? 0 : clamp(Math.floor((parts[at] * 0.5 + 0.5) * width) + border - texels, face.width);
  part.right = nothing ? 0 : clamp(Math.ceil((parts[at + 1] * 0.5 + 0.5) * width) + border + texels, face.width);
  part.bottom = nothing ? 0 : clamp(Math.floor((parts[at + 2] * 0.5 + 0.5) * height) + border - texels, face.height);
  part.top = nothing ? 0 : clamp(Math.ceil((parts[at + 3] * 0.5 + 0.5) * height) + border + texels, face.height);
}

function clamp(texel: number, most: number): number {
  return Math.min(most, Math.max(0, texel));
}

function isWhole({ part, width, height }: ShadowFace): boolean {
  return part.left === 0 && part.bottom === 0 && part.right === width && part.top === height;
}
