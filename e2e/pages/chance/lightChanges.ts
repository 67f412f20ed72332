import * as THREE from 'three';
import type { ChangingScene } from './ChangingScene';
import type { Dice } from './Dice';

/** One change of a scene or its host, of the kind that pages make between frames. */
export type Change = (world: ChangingScene, dice: Dice) => void;
type Cone = THREE.SpotLight;

const lightOf = ({ allLights }: ChangingScene, dice: Dice) => dice.of(allLights);
const coneOf = ({ lights }: ChangingScene, dice: Dice) => dice.of(lights.spot) as Cone | undefined;
const pointOf = ({ lights }: ChangingScene, dice: Dice) => dice.of(lights.point) as THREE.PointLight | undefined;
const sunOf = ({ lights }: ChangingScene) => lights.sun[0] as THREE.DirectionalLight | undefined;

/** Changes of lights and their shadows, by name. */
export const lightChanges: Record<string, Change> = {
  moveLight: (w, d) => lightOf(w, d).position.set(d.between(-4, 4), d.between(1.5, 5), d.between(-1, 5)),
  lightColor: (w, d) => {
    const light = lightOf(w, d);
    light.color.setHSL(d.next(), 0.7, 0.6);
    light.intensity *= d.between(0.7, 1.3);
  },
  lightRange: (w, d) => {
    const light = d.in(0.5) ? pointOf(w, d) : coneOf(w, d);
    if (light) light.distance = d.of([0, 0.5, 4, 12, 1e6]);
  },
  lightDecay: (w, d) => {
    const light = d.in(0.5) ? pointOf(w, d) : coneOf(w, d);
    if (light) light.decay = d.of([0, 1, 2, 3]);
  },
  cone: (w, d) => {
    const light = coneOf(w, d);
    if (light) Object.assign(light, { angle: d.of([0.001, 0.5, 1, Math.PI / 2]), penumbra: d.of([0, 0.5, 1]) });
  },
  target: (w, d) => {
    const light = (d.in(0.5) ? coneOf(w, d) : sunOf(w)) as Cone | undefined;
    light?.target.position.set(d.between(-2, 2), d.between(-1, 1), d.between(-2, 2));
  },
  targetOutside: (w, d) => void coneOf(w, d)?.target.removeFromParent(),
  casts: (w, d) => {
    const light = lightOf(w, d);
    light.castShadow = !light.castShadow;
  },
  lightVisible: (w, d) => {
    const light = lightOf(w, d);
    light.visible = !light.visible;
  },
  lightIntensity: (w, d) => void (lightOf(w, d).intensity = d.of([-2, 0, 5])),
  lightLayer: (w, d) => lightOf(w, d).layers.set(d.of([0, 1])),
  lightMap: (w, d) => {
    const light = coneOf(w, d);
    if (light) light.map = d.in(0.7) ? w.textures[0] : null;
  },
  mapSize: (w, d) => {
    const { shadow } = lightOf(w, d);
    shadow.mapSize.setScalar(d.of([32, 64, 128, 200, 256]));
    shadow.map?.dispose();
    shadow.map = null;
  },
  shadowSettings: (w, d) => {
    const { shadow } = lightOf(w, d);
    Object.assign(shadow, {
      bias: d.of([0, -0.01, -0.02]),
      normalBias: d.of([0, 0.03]),
      radius: d.of([0, 1, 3]),
      intensity: d.of([0.3, 1]),
      needsUpdate: true,
    });
  },
  shadowAutoUpdate: (w, d) => {
    const { shadow } = lightOf(w, d);
    shadow.autoUpdate = !shadow.autoUpdate;
    shadow.needsUpdate = true;
  },
  shadowCamera: (w, d) => {
    const camera = sunOf(w)?.shadow.camera;
    const reach = d.of([3, 5, 8]);
    Object.assign(camera ?? {}, { left: -reach, right: reach, top: reach, bottom: -reach });
    camera?.updateProjectionMatrix();
  },
  shadowPlanes: (w, d) => {
    const { camera } = lightOf(w, d).shadow;
    Object.assign(camera, { near: d.of([0.1, 0.5, 2]), far: d.of([6, 50, 500]) }).updateProjectionMatrix();
  },
  shadowType: (w, d) =>
    void (w.bench.webgl.shadowMap.type = d.of([THREE.BasicShadowMap, THREE.PCFShadowMap, THREE.VSMShadowMap])),
  shadowsOff: (w, d) => {
    w.bench.webgl.shadowMap.enabled = d.in(0.7);
    // programs are chosen anew, since stock three would go on using the maps it has
    for (const { material } of w.meshes) for (const one of [material].flat()) one.needsUpdate = true;
  },
  swapLight: (w, d) => {
    const kind = d.of(['point', 'spot', 'sun'] as const);
    const light = w.lights[kind].shift();
    if (!light) return;
    light.removeFromParent();
    light.dispose();
    w.addLight(kind, d).castShadow = light.castShadow;
  },
  addLight: (w, d) => {
    const kind = d.of(['point', 'spot'] as const);
    if (w.lights[kind].length < 3) w.addLight(kind, d, d.in(0.5) ? d.of(w.things) : w.scene);
  },
  removeLight: (w, d) => void w.lights[d.of(['point', 'spot'] as const)].pop()?.removeFromParent(),
  lightIntoThing: (w, d) => {
    const light = pointOf(w, d);
    if (light) d.of(w.things).add(light);
  },
};
