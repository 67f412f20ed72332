import type { Mesh, Object3D } from 'three';
import type { StageScene } from '../../stage/StageScene';
import { describePoints, writePositions } from './describeLights';
import type { Described } from './describeScene';
import { placementOf } from './placementOf';
import type { RivalDrawing, RivalPlacement, RivalPoints } from './RivalScene';

/** Tells another engine what moved in the case's scene since the last frame; allocates nothing. */
export class SceneFollower {
  private points: RivalPoints;
  /** Whether the engine has made its scene: until then it will take what stands in the data. */
  private hasStarted = false;
  /** Versions of the instances' matrices that the engine has. */
  private readonly versions: Int32Array;
  /** Where the lights of other kinds stand: [n, 3]. */
  private readonly places: Float32Array;

  constructor(
    private readonly stageScene: StageScene,
    private readonly described: Described,
    private readonly drawing: RivalDrawing,
  ) {
    const { scene, sources } = described;
    this.points = scene.points;
    this.places = Float32Array.from(stageScene.still.flatMap(({ position }) => position.toArray()));
    this.versions = Int32Array.from(sources, (mesh) => versionOf(mesh));
  }

  /** To be called when the engine has made its scene. */
  start(): void {
    this.hasStarted = true;
  }

  /** @throws Error when a light moves that is no point light */
  follow(): void {
    const { stageScene, drawing, points, described } = this;
    writePositions(stageScene.lights, points.positions);
    if (!this.hasStarted) return;
    drawing.moveLights(points);
    this.followMeshes();
    this.checkStill();
    const { camera } = stageScene;
    camera.updateWorldMatrix(true, false);
    if (take(camera, described.scene.camera.placement)) drawing.moveCamera();
  }

  changeLights(): void {
    this.points = describePoints(this.stageScene.lights);
    this.drawing.setLights(this.points);
  }

  private checkStill(): void {
    const { places } = this;
    const { still } = this.stageScene;
    for (let i = 0; i < still.length; i++) {
      const { x, y, z } = still[i].position;
      const isWhereItWas =
        places[i * 3] === Math.fround(x) &&
        places[i * 3 + 1] === Math.fround(y) &&
        places[i * 3 + 2] === Math.fround(z);
      if (isWhereItWas) continue;
      throw new Error('A light that is no point light moves: the Lab cannot give its path to other engines.');
    }
  }

  private followMeshes(): void {
    const { described, drawing, versions } = this;
    const { scene, sources } = described;
    for (let i = 0; i < sources.length; i++) {
      const mesh = sources[i];
      const version = versionOf(mesh);
      if (version !== versions[i]) {
        versions[i] = version;
        drawing.moveInstances(i);
      }
      // set by what moves a mesh, and taken back by three's renderers alone
      if (!mesh.matrixWorldNeedsUpdate) continue;
      mesh.updateWorldMatrix(true, false);
      mesh.matrixWorldNeedsUpdate = false;
      if (take(mesh, scene.meshes[i].placement)) drawing.moveMesh(i);
    }
  }
}

const versionOf = (mesh: Mesh): number =>
  (mesh as Mesh & { instanceMatrix?: { version: number } }).instanceMatrix?.version ?? 0;

const next: RivalPlacement = new Float32Array(10);

/** Takes where an object is now. @returns whether that has changed */
function take(object: Object3D, placement: RivalPlacement): boolean {
  placementOf(object, next);
  let isChanged = false;
  for (let k = 0; k < next.length; k++) {
    if (placement[k] === next[k]) continue;
    placement[k] = next[k];
    isChanged = true;
  }
  return isChanged;
}
