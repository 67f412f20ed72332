import { type Camera, type Material, Matrix4, type Mesh, type Object3D } from 'three';
import { hasOwnShader } from '../../frame/RenderQueue';
import { viewFrustumPlanes } from '../../lights/spheres';
import { boxInsidePlanes, boxOutsidePlanes, casterBox } from '../casters/casterBox';
import { CLUSTERS_PER_GROUP, type MergedCasters } from '../casters/merged';
import type { Caster } from '../casters/Caster';
import { findSphere, type ShadowCasters } from '../casters/ShadowCasters';
import { isBeyond, makeReach, setReach } from '../slots/reach';
import { hasNodes } from '../../three/hasNodes';
import type { ShadowFace } from '../slots/ShadowFace';
import type { ShadowSlot } from '../slots/ShadowSlot';
import { cubeFaceParts, openFaces } from './cubeFaceParts';
import { mapPart } from './mapPart';
import { Widest } from './Widest';

/** Factor by which the frustum is wider than the camera's, so that a slightly shaking camera finds no new receivers. */
const WIDER = 1.01;
/** Factor on the bounding spheres of objects whose vertices shaders may move. */
const SPHERES = 2;
/** Count of numbers in a group: its box, index of the first member and index after the last; a group without members is one box. */
const GROUP = 8;

const matrix = new Matrix4();
const planes = new Float64Array(24);
const parts = new Float64Array(24);
/** Faces of a cube map, as bits, whose visible part does not cover the whole face yet. */
let open = 63;
const reach = makeReach();
const sphere = { x: 0, y: 0, z: 0, radius: 0 };

/**
 * World-space boxes round the receivers of shadows that a camera may see. While casters move, maps are drawn only where these
 * boxes sample shadows, see `findParts`.
 * @see Bittner et al. 2011, Shadow Caster Culling for Efficient Shadow Mapping
 */
export class VisibleReceivers {
  /** Boxes along the world's axes: centre and half sizes (m), 6 numbers each. */
  private boxes = new Float64Array(6 * 256);
  private used = 0;
  /** Groups of boxes that lie close together, and groups of those groups, one for each object; see `GROUP`. */
  private groups = new Float64Array(GROUP * 64);
  private groupsUsed = 0;
  private objects = new Float64Array(GROUP * 64);
  private objectsUsed = 0;
  private readonly widest = new WeakMap<ShadowSlot, Widest>();
  /** Whether a visible object that receives shadows has no bounds. */
  private isUnbounded = false;

  /** Finds the boxes for a frame. @param merged - the merged casters, up to date */
  find({ list, count, receivers }: ShadowCasters, merged: MergedCasters | null, camera: Camera): void {
    this.used = this.groupsUsed = this.objectsUsed = 0;
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
      if (!object.receiveShadow || !object.layers.test(camera.layers)) continue;
      if (isBent(object)) this.addBent(list[i]);
      else this.addCaster(list[i], merged);
    }
    for (const object of receivers) {
      if (!object.layers.test(camera.layers)) continue;
      if (isBent(object)) {
        findSphere(object, sphere);
        this.addBent(sphere);
      } else this.addObject(object);
    }
  }

  /**
   * Finds the part of each face of a light's map that receivers sample, with the border that filters read.
   * @returns false if that is the whole map, or unknown
   */
  findParts(slot: ShadowSlot): boolean {
    if (this.isUnbounded) return false;
    const { faces, isCube, shadow } = slot;
    const { faceWidth, faceHeight, border } = slot.placement;
    const { radius } = shadow;
    const texels = Math.ceil(2 * radius) + 2;
    // distance along their normals at which receivers sample the map (m)
    const shift = Math.abs(slot.normalBias);
    parts.fill(-Infinity);
    open = 63;
    if (!isCube) {
      for (let i = 0; i < 24; i += 2) parts[i] = Infinity;
      for (const face of faces)
        face.matrix.multiplyMatrices(face.camera.projectionMatrix, face.camera.matrixWorldInverse);
    }
    const place = faces[0].camera.matrixWorld.elements;
    setReach(reach, place, slot.range + shift, 1 + (2 * texels) / faceWidth, shift);
    const { boxes, groups, objects, used } = this;
    const widest = this.widestOf(slot);
    for (let i = 0; i < widest.count; i++) {
      const at = widest.list[i];
      if (at < used && hold(slot, boxes, at)) widest.keep(at);
    }
    for (let object = 0; object < this.objectsUsed && open !== 0; object += GROUP) {
      if (isHeld(slot, objects, object)) continue;
      const endOfGroups = objects[object + 7];
      for (let group = objects[object + 6]; group < endOfGroups; group += GROUP) {
        if (isHeld(slot, groups, group)) continue;
        const end = groups[group + 7];
        for (let at = groups[group + 6]; at < end; at += 6) {
          if (hold(slot, boxes, at)) widest.find(at);
        }
      }
    }
    widest.end();
    if (isCube) for (let i = 0; i < 24; i += 2) parts[i] = -parts[i];
    let all = true;
    for (let i = 0; i < faces.length; i++) {
      setVisible(faces[i], i * 4, faceWidth, faceHeight, border, texels);
      all &&= isWhole(faces[i]);
    }
    return !all;
  }

  private widestOf(slot: ShadowSlot): Widest {
    let widest = this.widest.get(slot);
    if (widest === undefined) this.widest.set(slot, (widest = new Widest()));
    return widest;
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
    const firstGroup = this.groupsUsed;
    for (let group = 0; group < groups.length; group += 6) {
      if (boxOutsidePlanes(planes, groups, group)) continue;
      const isInside = boxInsidePlanes(planes, groups, group);
      const first = this.used;
      const end = Math.min(boxes.length, (group + 6) * CLUSTERS_PER_GROUP);
      for (let at = group * CLUSTERS_PER_GROUP; at < end; at += 6) {
        if (isInside || !boxOutsidePlanes(planes, boxes, at)) this.push(boxes, at);
      }
      if (this.used > first) this.addGroup(first, groups, group);
    }
    if (this.groupsUsed > firstGroup) this.addToObjects(box, firstGroup);
  }

  /** Adds a receiver that may be anywhere in its enlarged sphere, unless three culls it. */
  private addBent({ x, y, z, radius }: typeof sphere): void {
    if (Number.isFinite(radius)) {
      setCube(x, y, z, radius);
      if (boxOutsidePlanes(planes, objectBox)) return;
    }
    this.isUnbounded = true;
  }

  private addObject(object: Object3D): void {
    if (casterBox(object, objectBox)) {
      this.addBox(objectBox);
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
    setCube(x, y, z, SPHERES * radius);
    this.addBox(objectBox);
  }

  private addBox(box: Float64Array): void {
    if (boxOutsidePlanes(planes, box)) return;
    this.addToObjects(box, this.groupsUsed);
  }

  private push(boxes: Float64Array, at: number): void {
    if (this.used + 6 > this.boxes.length) this.boxes = grown(this.boxes);
    copyBox(boxes, at, this.boxes, this.used);
    this.used += 6;
  }

  /** Makes a group of the boxes from `first` on. @param round - holds the box around those boxes, from index `from` on */
  private addGroup(first: number, round: Float64Array, from: number): void {
    if (this.groupsUsed === this.groups.length) this.groups = grown(this.groups);
    copyBox(round, from, this.groups, this.groupsUsed);
    this.groups[this.groupsUsed + 6] = first;
    this.groups[this.groupsUsed + 7] = this.used;
    this.groupsUsed += GROUP;
  }

  /** Makes a group of the groups from `first` on. @param round - box around those groups */
  private addToObjects(round: Float64Array, first: number): void {
    if (this.objectsUsed === this.objects.length) this.objects = grown(this.objects);
    copyBox(round, 0, this.objects, this.objectsUsed);
    this.objects[this.objectsUsed + 6] = first;
    this.objects[this.objectsUsed + 7] = this.groupsUsed;
    this.objectsUsed += GROUP;
  }
}

const objectBox = new Float64Array(6);

function setCube(x: number, y: number, z: number, radius: number): void {
  objectBox[0] = x;
  objectBox[1] = y;
  objectBox[2] = z;
  objectBox[3] = objectBox[4] = objectBox[5] = radius;
}

/** Whether the page's own vertex shader may move an object's vertices. */
function isBent(object: Object3D): boolean {
  const { material } = object as Mesh;
  if (!Array.isArray(material)) return bends(material);
  for (let i = 0; i < material.length; i++) if (material[i] && bends(material[i])) return true;
  return false;
}

const bends = (material: Material): boolean => hasOwnShader(material) || hasNodes(material);

function grown(numbers: Float64Array): Float64Array<ArrayBuffer> {
  const more = new Float64Array(numbers.length * 2);
  more.set(numbers);
  return more;
}

/** True when a shadow map's visible parts contain a group of receivers within the light's range; widens them by a little. */
function isHeld(slot: ShadowSlot, groups: Float64Array, at: number): boolean {
  const isLeaf = groups[at + 6] === groups[at + 7];
  if (isLeaf) hold(slot, groups, at);
  else if (slot.isCube) {
    const widens = cubeFaceParts(parts, groups, at, reach, open, false);
    if (widens === 2) return false;
    if (widens === 1) hold(slot, groups, at);
  } else if (!isBeyond(reach, groups, at)) {
    const { faces } = slot;
    for (let i = 0; i < faces.length; i++)
      if (mapPart(parts, i * 4, groups, at, reach, faces[i].matrix, false)) return false;
  }
  return true;
}

/** Widens the visible parts to hold the part of a box within range. @returns whether they were widened */
function hold({ isCube, faces }: ShadowSlot, boxes: Float64Array, at: number): boolean {
  let widens = false;
  if (isCube) {
    widens = cubeFaceParts(parts, boxes, at, reach, open) !== 0;
    if (widens) open = openFaces(parts);
  } else if (!isBeyond(reach, boxes, at)) {
    for (let i = 0; i < faces.length; i++) {
      if (mapPart(parts, i * 4, boxes, at, reach, faces[i].matrix)) widens = true;
    }
  }
  return widens;
}

function copyBox(from: Float64Array, at: number, to: Float64Array, index: number): void {
  for (let i = 0; i < 6; i++) to[index + i] = from[at + i];
}

/** Sets the visible part of a face (texels) from `parts`, with a border of `texels` for filters. */
function setVisible(face: ShadowFace, at: number, width: number, height: number, border: number, texels: number): void {
  const { visible } = face;
  const nothing = parts[at] > parts[at + 1];
  visible.left = nothing ? 0 : clamp(Math.floor((parts[at] * 0.5 + 0.5) * width) + border - texels, face.width);
  visible.right = nothing ? 0 : clamp(Math.ceil((parts[at + 1] * 0.5 + 0.5) * width) + border + texels, face.width);
  visible.bottom = nothing ? 0 : clamp(Math.floor((parts[at + 2] * 0.5 + 0.5) * height) + border - texels, face.height);
  visible.top = nothing ? 0 : clamp(Math.ceil((parts[at + 3] * 0.5 + 0.5) * height) + border + texels, face.height);
}

function clamp(texel: number, most: number): number {
  return Math.min(most, Math.max(0, texel));
}

function isWhole({ visible, width, height }: ShadowFace): boolean {
  return visible.left === 0 && visible.bottom === 0 && visible.right === width && visible.top === height;
}
