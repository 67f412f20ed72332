import {
  type Camera,
  type Light,
  type Matrix4,
  type Mesh,
  type Object3D,
  PointLight,
  Scene,
  type SpotLight,
} from 'three';
import type { LabCase } from '../plan/LabPlan';
import { castShadow, copyLight } from './copyLight';
import { evenly } from './lightChoice';
import { LightPaths } from './LightPaths';
import { overdrawLayers } from './overdrawLayers';
import { SceneCopier } from './SceneCopier';
import type { StageScene } from './StageScene';
import type { StageTemplate } from './StageTemplate';

/** How far beside another light an added one is put, along x and z (m). */
const BESIDE = 0.3;

/** A light of the engine's scene and its copy, which goes where the engine moves it. */
interface Follower<T extends Object3D> {
  readonly source: T;
  readonly copy: T;
}

/** Times at which a scene that was handed over is looked at, to see what of it moves (s). */
const LOOKS = [0.37, 1.9, 7.3, 23.1, 61.7];

/**
 * A competitor's own scene of a case: the same numbers for every competitor and in every run.
 *
 * @param template of the case's scene, made with at least as many lights
 */
export function buildStageScene(labCase: LabCase, template: StageTemplate): StageScene & { dispose(): void } {
  const { width, height } = labCase;
  const copier = new SceneCopier();
  const three = new Scene();
  const source = template.scene.three;
  three.background = copier.background(source.background as never) as Scene['background'];
  three.environment = source.environment ? copier.texture(source.environment) : null;
  three.environmentIntensity = source.environmentIntensity;
  three.backgroundIntensity = source.backgroundIntensity;
  three.fog = source.fog ? source.fog.clone() : null;

  const camera = copyCamera(template.camera);
  const still: Light[] = [];
  const points: PointLight[] = [];
  const lightFollowers: Follower<Light>[] = [];
  // the engine moves a scene that was handed over; of our own scenes only lights move
  const follows = labCase.lights === null;
  for (const other of template.others) {
    const copy = copyLight(other);
    if (!copy) continue;
    three.add(copy);
    const { target } = copy as SpotLight;
    if (target) three.add(target);
    if (follows) lightFollowers.push({ source: other, copy });
    if (follows && copy instanceof PointLight) points.push(copy);
    else still.push(copy);
  }
  const chosen = evenly(labCase.lights ?? template.moving.length, template.moving.length).map(
    (i) => template.moving[i],
  );
  let paths = chosen.map(({ path }) => path);
  let places = new LightPaths(paths);
  chosen.forEach(({ light }, i) => {
    const copy = copyLight(light) as PointLight;
    copy.castShadow = false;
    if (i < labCase.shadows) castShadow(copy);
    points.push(copy);
    three.add(copy);
  });

  const followers: Follower<Object3D>[] = [];
  for (const drawn of template.drawn) {
    const copy = copier.object(drawn) as Mesh;
    if (labCase.shadows > 0) copy.castShadow = copy.receiveShadow = true;
    if (follows) followers.push({ source: drawn, copy });
    three.add(copy);
  }
  if (labCase.overdraw > 0) {
    const lit = points.map(({ position }) => position.clone());
    for (const layer of overdrawLayers(labCase.overdraw, camera, lit)) three.add(copier.object(fixed(layer)));
  }
  const moved = follows ? thatMove(followers, template) : [];
  const movedLights = follows ? thatMove(lightFollowers, template) : [];
  let seconds = 0;

  function setTime(time: number): void {
    seconds = time;
    if (!follows) {
      for (let i = 0; i < points.length; i++) places.place(i, time, points[i].position);
      return;
    }
    template.scene.setTime(time);
    source.updateMatrixWorld();
    for (let i = 0; i < moved.length; i++) {
      const { source: mesh, copy } = moved[i];
      copy.matrix.copy(mesh.matrixWorld);
      copy.matrixWorldNeedsUpdate = true;
    }
    for (let i = 0; i < movedLights.length; i++) follow(movedLights[i]);
    camera.position.setFromMatrixPosition(template.camera.matrixWorld);
    camera.quaternion.setFromRotationMatrix(template.camera.matrixWorld);
  }

  function addLights(count: number): () => void {
    const pathsBefore = paths;
    const placesBefore = places;
    const before = points.length;
    for (let i = 0; i < count; i++) {
      const beside = before > 0 ? Math.floor((i * before) / count) : -1;
      const light = beside < 0 ? lightBefore(camera) : points[beside].clone(false);
      light.castShadow = false;
      light.position.x += BESIDE;
      light.position.z += BESIDE;
      if (!follows) {
        const path = paths[beside] ?? { extent: [1, 1, 1], speed: 1, seed: i + 1 };
        const [x, y, z] = beside < 0 ? light.position.toArray() : path.place;
        paths = [...paths, { ...path, place: [x + BESIDE, y, z + BESIDE] }];
      }
      points.push(light);
      three.add(light);
    }
    places = new LightPaths(paths);
    return () => {
      for (const light of points.splice(before)) {
        light.removeFromParent();
        light.dispose();
      }
      paths = pathsBefore;
      places = placesBefore;
    };
  }

  setTime(seconds);
  return {
    ...{ three, camera, lights: points, still, width, height, setTime, addLights },
    dispose() {
      copier.dispose();
      for (const light of [...points, ...still]) light.dispose();
      three.clear();
    },
  };
}

/** What of a scene that was handed over is ever elsewhere than at time 0. */
function thatMove<T extends Object3D>(followers: readonly Follower<T>[], { scene }: StageTemplate): Follower<T>[] {
  const matricesAt = (seconds: number): Matrix4[] => {
    scene.setTime(seconds);
    scene.three.updateMatrixWorld();
    return followers.flatMap(({ source }) => [
      source.matrixWorld.clone(),
      ((source as unknown as Partial<SpotLight>).target ?? source).matrixWorld.clone(),
    ]);
  };
  const looks = LOOKS.map(matricesAt);
  const begin = matricesAt(0);
  const differs = (at: number): boolean => looks.some((matrices) => !matrices[at].equals(begin[at]));
  return followers.filter((_, i) => differs(2 * i) || differs(2 * i + 1));
}

/** Brings a light where the one of the engine's scene is. */
function follow({ source, copy }: Follower<Light>): void {
  copy.position.setFromMatrixPosition(source.matrixWorld);
  const { target } = copy as SpotLight;
  if (target) target.position.setFromMatrixPosition((source as SpotLight).target.matrixWorld);
}

/** A camera without a parent, where the engine's camera is. */
function copyCamera(source: Camera): Camera {
  const camera = (source as Object3D).clone(false) as Camera;
  camera.position.setFromMatrixPosition(source.matrixWorld);
  camera.quaternion.setFromRotationMatrix(source.matrixWorld);
  camera.scale.setScalar(1);
  camera.updateMatrixWorld(true);
  return camera;
}

/** A light in front of the camera, for a scene that has none. */
function lightBefore(camera: Camera): PointLight {
  const light = new PointLight(0xffffff, 5, 10);
  light.position.set(0, 0, -5).applyMatrix4(camera.matrixWorld);
  return light;
}

/** A mesh whose world matrix is its own matrix. */
function fixed(mesh: Mesh): Mesh {
  mesh.matrixWorld.copy(mesh.matrix);
  return mesh;
}
