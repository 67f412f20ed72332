import { AssetLibrary } from '@farol/engine';
import type { BufferGeometry, Mesh, MeshStandardMaterial, PerspectiveCamera } from 'three';
import { loadCompetitor } from '../competitors';
import { plainCase } from '../plan/LabPlan';
import { readPicture } from '../measure/readPicture';
import { loseContext } from '../stage/loseContext';
import { type OwnedScene, StageScenes } from '../stage/StageScenes';
import { countLeaning, withFaceNormals } from './withFaceNormals';
import { creaseAngle, type NormalsPicture, type NormalsWay } from './NormalsPicture';

/** Point lights, as in the thesis's picture of Sponza. */
const LIGHTS = 50;

/** Limit of the first frame (ms). */
const LONGEST = 60_000;

/** A copy of a geometry without normals. */
function bare(geometry: BufferGeometry): BufferGeometry {
  const copy = geometry.clone();
  copy.deleteAttribute('normal');
  return copy;
}

/** Removes the normals of all meshes and computes them anew. @returns share of leaning corners, 0 to 1 */
async function recompute(scene: OwnedScene, way: NormalsWay, assets: AssetLibrary): Promise<number> {
  const made = new Map<BufferGeometry, BufferGeometry>();
  let corners = 0;
  let leaning = 0;
  for (const object of scene.three.children) {
    const mesh = object as Mesh<BufferGeometry, MeshStandardMaterial>;
    if (!mesh.isMesh) continue;
    let geometry = made.get(mesh.geometry);
    if (!geometry) {
      if (way === 'faces') geometry = withFaceNormals(bare(mesh.geometry));
      else {
        const name = `normals/${made.size}`;
        assets.register(name, bare(mesh.geometry));
        geometry = await assets.prepareMesh(name, creaseAngle);
      }
      made.set(mesh.geometry, geometry);
    }
    mesh.geometry = geometry;
    const counted = countLeaning(geometry, creaseAngle);
    corners += counted.corners;
    leaning += counted.leaning;
    // normal maps would hide the difference
    mesh.material.normalMap = null;
  }
  return leaning / Math.max(1, corners);
}

/** Points the camera at the walls between the arches, where the thesis's picture has stripes and rhombi. */
function aim(camera: PerspectiveCamera): void {
  camera.position.set(-12.5, 4.6, 1.2);
  camera.lookAt(-9.6, 5.3, -5);
  camera.fov = 38;
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld(true);
}

/**
 * Draws one of the two pictures of figure 4.3 of the thesis.
 *
 * @param size - of the picture (pixels)
 * @throws Error (as a rejection) that names what the device or the browser cannot do
 */
export async function drawNormals(way: NormalsWay, size: { width: number; height: number }): Promise<NormalsPicture> {
  const parameters = {};
  const scenery = { scene: { name: 'sponza', parameters }, lights: LIGHTS, shadows: 0, overdraw: 0 };
  const labCase = { ...plainCase, ...scenery, ...size };
  const scene = await new StageScenes().build(labCase);
  const assets = new AssetLibrary();
  const canvas = document.createElement('canvas');
  Object.assign(canvas, size);
  try {
    const leaning = await recompute(scene, way, assets);
    aim(scene.camera as PerspectiveCamera);
    const competitor = await loadCompetitor('deferred');
    const drawing = await competitor.open(canvas, scene, new AbortController().signal, LONGEST);
    try {
      scene.setTime(0);
      drawing.render();
      drawing.check?.();
      return { picture: readPicture(canvas, size.width), leaning };
    } finally {
      drawing.dispose();
      if (drawing.gl) loseContext(drawing.gl);
    }
  } finally {
    scene.dispose();
    assets.dispose();
  }
}
