import type { GameObject, Scene } from '@farol/engine';
import { Box3, type Intersection, Matrix3, Mesh, MeshBasicMaterial, Raycaster, Vector3 } from 'three';
import { readableMeshes } from '../drawnMeshes';
import { castMesh } from '../trees/castByTree';

const matrix = new Matrix3();
const normal = new Vector3();
const DOWN = new Vector3(0, -1, 0);
/** Height above a point from which surfaces are searched downwards when none is below it (m). */
const SKY = 10_000;

interface Candidate {
  readonly box: Box3;
  readonly mesh: Mesh;
}

/** Finds the surface below points, for many points of one scene, as of the last drawn frame. */
export class SurfaceBelow {
  private readonly candidates: Candidate[] = [];
  private readonly raycaster = new Raycaster();
  private readonly material = new MeshBasicMaterial({ side: 2 });
  private readonly hits: Intersection[] = [];

  /** @param without - objects to ignore, with their descendants */
  constructor(scene: Scene, without: ReadonlySet<GameObject>) {
    const visit = (object: GameObject): void => {
      if (without.has(object) || !object.active) return;
      readableMeshes(object, (drawn, geometry, matrixWorld) => {
        if (drawn && !drawn.visible) return;
        const mesh = drawn ?? new Mesh(geometry, this.material);
        if (!drawn) mesh.matrixWorld.copy(matrixWorld);
        if (!geometry.boundingBox) geometry.computeBoundingBox();
        // bones and morph targets may reach beyond the geometry's box
        const box = geometry.boundingBox!.clone().applyMatrix4(matrixWorld).expandByScalar(0.01);
        this.candidates.push({ box, mesh });
      });
      object.children.forEach(visit);
    };
    scene.roots.forEach(visit);
  }

  /** Height (m) of the first surface below a point; else of the highest one above; else 0, the ground. */
  heightAt({ x, y, z }: { readonly x: number; readonly y: number; readonly z: number }): number {
    return this.firstBelow(x, y + 1e-3, z) ?? this.firstBelow(x, y + SKY, z) ?? 0;
  }

  private firstBelow(x: number, y: number, z: number): number | null {
    const { raycaster, hits } = this;
    raycaster.ray.origin.set(x, y, z);
    raycaster.ray.direction.copy(DOWN);
    hits.length = 0;
    for (const { box, mesh } of this.candidates) {
      const { min, max } = box;
      if (x < min.x || x > max.x || z < min.z || z > max.z || y < min.y) continue;
      castMesh(mesh, raycaster, hits);
    }
    let highest: number | null = null;
    for (const { point, face, object } of hits) {
      // a back face, hit from inside, is not a floor
      if (face && normal.copy(face.normal).applyMatrix3(matrix.getNormalMatrix(object.matrixWorld)).y <= 0) continue;
      if (highest === null || point.y > highest) highest = point.y;
    }
    return highest;
  }
}
