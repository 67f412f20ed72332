import type { Mesh, Object3D } from 'three';
import type { StageScene } from '../../stage/StageScene';
import { describePoints, writePositions } from './describeLights';
import type { Described } from './describeScene';
import { placementOf } from './placementOf';
import type { RivalDrawing, RivalPlacement, RivalPoints } from './RivalScene';

/** Applies movements in the case's scene to another engine's scene each frame; allocates nothing. */
export class SceneFollower {
  private points: RivalPoints;
  /** Whether the engine has made its scene; it reads the initial poses itself. */
  private hasStarted = false;
  /** Versions of the instance matrices last sent to the engine, by mesh. */
  private readonly versions: Int32Array;
  /** Positions of the still lights, to check that none moves: [n, 3]. */
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

  /** Starts applying movements; called once the engine has made its scene. */
  start(): void {
    this.hasStarted = true;
  }

  /** Applies movements since the last frame. @throws Error when another light than a point light moves */
  follow(): void {
    const { stageScene, drawing, points, described } = this;
    writePositions(stageScene.lights, points.positions);
    if (!this.hasStarted) return;
    drawing.moveLights(points);
    this.followMeshes();
    this.checkStill();
    const { camera } = stageScene;
    camera.updateWorldMatrix(true, false);
    if (updatePlacement(camera, described.scene.camera.placement)) drawing.moveCamera();
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
      const isUnmoved =
        places[i * 3] === Math.fround(x) &&
        places[i * 3 + 1] === Math.fround(y) &&
        places[i * 3 + 2] === Math.fround(z);
      if (isUnmoved) continue;
      throw new Error('Only point lights may move: the Lab cannot give other paths to other engines.');
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
      // this flag is set by the code that moves a mesh, and reset only by three's renderers
      if (!mesh.matrixWorldNeedsUpdate) continue;
      mesh.updateWorldMatrix(true, false);
      mesh.matrixWorldNeedsUpdate = false;
      if (updatePlacement(mesh, scene.meshes[i].placement)) drawing.moveMesh(i);
    }
  }
}

const versionOf = (mesh: Mesh): number =>
  (mesh as Mesh & { instanceMatrix?: { version: number } }).instanceMatrix?.version ?? 0;

const next: RivalPlacement = new Float32Array(10);

/** Copies an object's world matrix to a placement. @returns whether it changed */
function updatePlacement(object: Object3D, placement: RivalPlacement): boolean {
  placementOf(object, next);
  let isChanged = false;
  for (let k = 0; k < next.length; k++) {
    if (placement[k] === next[k]) continue;
    placement[k] = next[k];
    isChanged = true;
  }
  return isChanged;
}
