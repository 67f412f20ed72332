import type { GameObject, Scene } from '@farol/engine';
import { Box3, type BufferAttribute, type Camera, type Object3D, Quaternion, type Ray, Vector3 } from 'three';
import { boundsOf } from '../boundsOf';
import { readableMeshes } from '../drawnMeshes';
import { surfacesAlong } from '../placing/surfaces';
import { nearestVertex } from './nearestVertex';

/** Target that drags snap to. */
export type SnapTarget = 'grid' | 'surface' | 'vertex';

/** Maximum number of vertices of dragged objects that may snap; with more, the corners of their common box snap. */
const MOST_VERTICES = 3000;
/** Distance that objects without a mesh, such as lights, keep from a surface (m). */
const CLEARANCE = 0.1;

const UP = new Vector3(0, 1, 0);
const corner = new Vector3();

/** World positions of the vertices of objects; the corners of their box when there are too many. */
function verticesOf(objects: readonly GameObject[], box: Box3): Vector3[] {
  const vertices: Vector3[] = [];
  for (const root of objects) {
    root.traverse((object) =>
      readableMeshes(object, (mesh, geometry, matrix) => {
        const positions = geometry.getAttribute('position') as BufferAttribute | undefined;
        if (!positions) return;
        const count = Math.min(positions.count, MOST_VERTICES + 1 - vertices.length);
        for (let i = 0; i < count; i++) {
          const place = new Vector3();
          if (mesh) mesh.getVertexPosition(i, place);
          else place.fromBufferAttribute(positions, i);
          vertices.push(place.applyMatrix4(matrix));
        }
      }),
    );
  }
  if (vertices.length > 0 && vertices.length <= MOST_VERTICES) return vertices;
  return box.isEmpty() ? [] : cornersOf(box);
}

const cornersOf = ({ min, max }: Box3): Vector3[] =>
  [0, 1, 2, 3, 4, 5, 6, 7].map(
    (bits) => new Vector3(bits & 1 ? max.x : min.x, bits & 2 ? max.y : min.y, bits & 4 ? max.z : min.z),
  );

/** Snaps a drag to the surface or the vertex under the pointer. */
export class DragSnap {
  private readonly without: ReadonlySet<GameObject>;
  private readonly box: Box3;
  private readonly hasShape: boolean;
  private vertices: Vector3[] | null = null;
  private readonly start = new Vector3();
  private readonly startTurn = new Quaternion();

  /**
   * @param dragged - objects, in their poses before the drag
   * @param pivot - object in its pose before the drag; no descendant of the dragged ones
   */
  constructor(
    private readonly scene: Scene,
    private readonly dragged: readonly GameObject[],
    pivot: Object3D,
  ) {
    this.without = new Set(dragged);
    this.box = boundsOf(dragged);
    this.start.copy(pivot.position);
    this.startTurn.copy(pivot.quaternion);
    this.hasShape = !this.box.isEmpty() && this.box.getSize(corner).length() > 0;
  }

  /**
   * Moves the pivot so that the dragged objects touch the surface that a ray hits.
   * @param aligns - whether the pivot is rotated so that its y axis is the normal
   * @param restrict - removes the components of a movement that the handle does not allow
   * @returns whether a surface was hit
   */
  toSurface(pivot: Object3D, ray: Ray, camera: Camera, aligns: boolean, restrict: (way: Vector3) => void): boolean {
    const surface = surfacesAlong(this.scene, ray, camera, this.without).at(0);
    if (!surface) return false;
    const { normal, point } = surface;
    const up = aligns ? UP.clone().applyQuaternion(this.startTurn) : normal;
    let foot = this.hasShape ? 0 : CLEARANCE;
    if (this.hasShape)
      for (const each of cornersOf(this.box)) foot = Math.max(foot, -up.dot(corner.copy(each).sub(this.start)));
    const way = point.clone().addScaledVector(normal, foot).sub(this.start);
    restrict(way);
    pivot.position.copy(this.start).add(way);
    pivot.quaternion.copy(this.startTurn);
    if (aligns) pivot.quaternion.premultiply(new Quaternion().setFromUnitVectors(up, normal));
    return true;
  }

  /**
   * Moves the pivot so that the closest vertex of the dragged objects lies on the vertex under a ray.
   * @returns the vertex under the ray (world); null when there is none
   */
  toVertex(pivot: Object3D, ray: Ray, camera: Camera, restrict: (way: Vector3) => void): Vector3 | null {
    const target = nearestVertex(this.scene, ray, camera, this.without);
    if (!target) return null;
    this.vertices ??= verticesOf(this.dragged, this.box);
    const moved = pivot.position.clone().sub(this.start);
    const way = target.clone().sub(this.start);
    let leastDistance = Infinity;
    for (const vertex of this.vertices) {
      const distance = corner.copy(vertex).add(moved).distanceToSquared(target);
      if (distance >= leastDistance) continue;
      leastDistance = distance;
      way.copy(target).sub(vertex);
    }
    restrict(way);
    pivot.position.copy(this.start).add(way);
    return target;
  }
}
