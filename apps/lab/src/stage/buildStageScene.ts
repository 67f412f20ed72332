import {
  type Camera,
  type Light,
  type Matrix4,
  type Mesh,
  type Object3D,
  PointLight,
  Scene,
  type SpotLight,
  type Texture,
} from 'three';
import { isSingleLightKind } from '../plan/lightKinds';
import type { LabCase } from '../plan/LabPlan';
import { castShadow, copyLight } from './copyLight';
import { evenly } from './lightChoice';
import { LightPaths } from './LightPaths';
import { movingField } from './movingField';
import { lightMaker } from './movingLights';
import { movingParticles } from './movingParticles';
import { overdrawLayers } from './overdrawLayers';
import { SceneCopier } from './SceneCopier';
import type { MovingLight, StageScene } from './StageScene';
import type { StageTemplate } from './StageTemplate';

/** Distance of an added light from an existing one along x, and along z (m). */
const BESIDE = 0.3;

/** An object of the engine's scene, and its copy, which is moved with it. */
interface Follower<T extends Object3D> {
  readonly source: T;
  readonly copy: T;
}

/** Times at which the poses of a handed-over scene are compared with those at time 0, to find what moves (s). */
const SAMPLE_TIMES = [0.37, 1.9, 7.3, 23.1, 61.7];

/**
 * Creates a competitor's scene for a case: equal for every competitor and in every run.
 *
 * @param template - parts of the case's scene, with at least as many lights
 * @param profiles - light profiles, which are copied for the scene
 */
export function buildStageScene(
  labCase: LabCase,
  template: StageTemplate,
  profiles: readonly Texture[] = [],
): StageScene & { dispose(): void } {
  const { width, height, lightKind: kind, lightRange, shading } = labCase;
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
  const lights: MovingLight[] = [];
  const lightFollowers: Follower<Light>[] = [];
  // the engine moves a handed-over scene; in the demo scenes only the lights move
  const follows = labCase.lights === null;
  for (const other of template.others) {
    const copy = copyLight(other);
    if (!copy) continue;
    three.add(copy);
    const { target } = copy as SpotLight;
    if (target) three.add(target);
    if (follows) lightFollowers.push({ source: other, copy });
    if (follows && copy instanceof PointLight) lights.push(copy);
    else still.push(copy);
  }
  const chosen = evenly(labCase.lights ?? template.moving.length, template.moving.length).map(
    (i) => template.moving[i],
  );
  let paths = chosen.map(({ path }) => path);
  let places = new LightPaths(paths);
  const sources = chosen.map(({ light }, i) => {
    const copy = copyLight(light) as PointLight;
    copy.castShadow = false;
    if (lightRange !== null) copy.distance = lightRange;
    if (i < labCase.shadows) castShadow(copy);
    return copy;
  });
  const ownProfiles = kind === 'profiles' ? profiles.map((texture) => texture.clone()) : [];
  const make = lightMaker(isSingleLightKind(kind) ? kind : 'points', ownProfiles);
  const field = kind === 'field' ? movingField(sources) : null;
  const particles = kind === 'particles' ? movingParticles(sources, paths) : null;
  if (field) three.add(field.field);
  else if (particles) three.add(particles.emitter);
  else for (const source of sources) addLight(make(source, lights.length));

  function addLight(light: MovingLight): void {
    lights.push(light);
    three.add(light);
  }

  const followers: Follower<Object3D>[] = [];
  for (const drawn of template.drawn) {
    const copy = copier.object(drawn) as Mesh;
    if (labCase.shadows > 0) copy.castShadow = copy.receiveShadow = true;
    if (follows) followers.push({ source: drawn, copy });
    three.add(copy);
  }
  if (labCase.overdraw > 0) {
    const lit = [...lights, ...sources].map(({ position }) => position.clone());
    for (const layer of overdrawLayers(labCase.overdraw, camera, lit)) three.add(copier.object(fixed(layer)));
  }
  const moved = follows ? movingOf(followers, template) : [];
  const movedLights = follows ? movingOf(lightFollowers, template) : [];
  let seconds = 0;

  function setTime(time: number): void {
    seconds = time;
    if (!follows) {
      if (field) field.place(places, time);
      else if (particles) particles.setTime(time);
      else for (let i = 0; i < lights.length; i++) places.place(i, time, lights[i].position);
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
    const [oldPaths, oldPlaces, oldCount] = [paths, places, lights.length];
    const existing = follows ? (lights as PointLight[]) : sources;
    const known = existing.length;
    for (let i = 0; i < count; i++) {
      const beside = known > 0 ? Math.floor((i * known) / count) : -1;
      const light = beside < 0 ? lightBefore(camera) : existing[beside].clone(false);
      light.castShadow = false;
      light.position.x += BESIDE;
      light.position.z += BESIDE;
      if (!follows) {
        const path = paths[beside] ?? { extent: [1, 1, 1], speed: 1, seed: i + 1 };
        const [x, y, z] = beside < 0 ? light.position.toArray() : path.place;
        paths = [...paths, { ...path, place: [x + BESIDE, y, z + BESIDE] }];
      }
      if (field) field.add(light);
      else addLight(make(light, lights.length));
    }
    places = new LightPaths(paths);
    return () => {
      field?.remove(count);
      for (const light of lights.splice(oldCount)) {
        light.removeFromParent();
        light.dispose();
      }
      paths = oldPaths;
      places = oldPlaces;
    };
  }

  if (shading !== 'own') copier.shade(shading);
  setTime(seconds);
  return {
    ...{ three, camera, kind, shading, lights, still, width, height, setTime, addLights },
    emitter: particles?.emitter ?? null,
    dispose() {
      copier.dispose();
      for (const light of [...lights, ...still]) light.dispose();
      for (const each of [...ownProfiles, ...(field ? [field.field] : []), ...(particles ? [particles.emitter] : [])]) {
        each.dispose();
      }
      three.clear();
    },
  };
}

/** Objects of a handed-over scene whose pose in any of the samples differs from that at time 0. */
function movingOf<T extends Object3D>(followers: readonly Follower<T>[], { scene }: StageTemplate): Follower<T>[] {
  const matricesAt = (seconds: number): Matrix4[] => {
    scene.setTime(seconds);
    scene.three.updateMatrixWorld();
    return followers.flatMap(({ source }) => [
      source.matrixWorld.clone(),
      ((source as unknown as Partial<SpotLight>).target ?? source).matrixWorld.clone(),
    ]);
  };
  const samples = SAMPLE_TIMES.map(matricesAt);
  const begin = matricesAt(0);
  const differs = (at: number): boolean => samples.some((matrices) => !matrices[at].equals(begin[at]));
  return followers.filter((_, i) => differs(2 * i) || differs(2 * i + 1));
}

/** Moves the copy of a light to where the original is. */
function follow({ source, copy }: Follower<Light>): void {
  copy.position.setFromMatrixPosition(source.matrixWorld);
  const { target } = copy as SpotLight;
  if (target) target.position.setFromMatrixPosition((source as SpotLight).target.matrixWorld);
}

/** Copies the engine's camera, without a parent, at its world pose. */
function copyCamera(source: Camera): Camera {
  const camera = (source as Object3D).clone(false) as Camera;
  camera.position.setFromMatrixPosition(source.matrixWorld);
  camera.quaternion.setFromRotationMatrix(source.matrixWorld);
  camera.scale.setScalar(1);
  camera.updateMatrixWorld(true);
  return camera;
}

/** A light in front of the camera, for a scene without lights. */
function lightBefore(camera: Camera): PointLight {
  const light = new PointLight(0xffffff, 5, 10);
  light.position.set(0, 0, -5).applyMatrix4(camera.matrixWorld);
  return light;
}

/** Freezes the matrix of a mesh without a parent. */
function fixed(mesh: Mesh): Mesh {
  mesh.matrixWorld.copy(mesh.matrix);
  return mesh;
}
