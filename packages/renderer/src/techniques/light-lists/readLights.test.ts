import { Camera, Color, Group, Matrix4, Mesh, PointLight, Quaternion, Scene, SpotLight, Vector3 } from 'three';
import { beforeAll, expect, it } from 'vitest';
import { setLightOptions } from '../../light-options';
import { fetching } from '../../lights/fetching';
import { FoundLights } from '../../lights/FoundLights';
import { POINT, readPoint } from '../../lights/plainPoints';
import { collectLights } from '../../renderer/collectLights';
import { readLightsInRows } from './readLights';

const left = { shadows: false, cookies: false, areas: false, all: false };

/** A scene with enough lights to be read ahead, and some that are not point lights. */
function makeScene(): { scene: Scene; lights: PointLight[]; group: Group } {
  const group = new Group();
  group.position.set(1, 2, 3);
  const lights = Array.from({ length: 70 }, (_, i) => {
    const light = new PointLight(0xff8040, 1 + i, 5, 2);
    light.position.set(i, 2 * i, 1 - i);
    return light;
  });
  const scene = new Scene().add(new Mesh(), ...lights.slice(0, 40), new SpotLight(), group, ...lights.slice(40));
  return { scene, lights, group };
}

type Change = (lights: PointLight[], group: Group, scene: Scene) => void;

/** Changes of lights by a host, applied one after another. */
const changes: Record<string, Change> = {
  'all are moved': (lights) => lights.forEach(({ position }, i) => position.set(1 - i, i / 3, 1)),
  'nothing happens': () => undefined,
  'one is turned': ([light]) => light.rotation.set(0.3, 0.2, 0.1),
  'one is turned about z': (lights) => (lights[1].rotation.z = 0.5),
  'its quaternion is replaced by numbers': (lights) => lights[1].quaternion.copy(new Quaternion(0, 0, 1, 0)),
  'its quaternion is mirrored': ([, { quaternion }]) => quaternion.set(1, 0, 0, 0),
  'one number of a quaternion is written': ([, { quaternion }]) => void (quaternion.z = 0.9),
  'one is scaled along x': (lights) => (lights[2].scale.x = 2),
  'one is scaled': (lights) => lights[2].scale.set(2, 3, 4),
  'one moves along z alone': (lights) => (lights[3].position.z = 9),
  'its colour is replaced': (lights) => (lights[4].color = new Color(1, 2, 3)),
  'a channel of its colour is written': (lights) => (lights[4].color.g = 7),
  'intensity, range and decay change': (lights) => Object.assign(lights[5], { intensity: 9, distance: 3, decay: 1 }),
  'a range of none': (lights) => (lights[5].distance = 0),
  'a place that is no number': (lights) => (lights[6].position.x = NaN),
  'a place that is a number again': (lights) => (lights[6].position.x = 3),
  'an intensity without end': (lights) => (lights[6].intensity = Infinity),
  'one is hidden, and moves': (lights) => Object.assign(lights[7], { visible: false }).position.set(1, 1, 1),
  'it is seen again': (lights) => (lights[7].visible = true),
  'it is in a layer that the camera does not see': (lights) => lights[7].layers.set(4),
  'it is in layer 0 again, with others': (lights) => lights[7].layers.enableAll(),
  'one casts a shadow': (lights) => (lights[8].castShadow = true),
  'it is turned, and casts none': (lights) => {
    lights[8].castShadow = false;
    lights[8].rotation.y = 1;
  },
  'one casts a shadow again, and is turned about z': (lights) => {
    lights[8].castShadow = true;
    lights[8].rotation.set(0, 0, 1);
  },
  'it is turned back, and casts none': (lights) => {
    lights[8].castShadow = false;
    lights[8].rotation.set(0, 1, 0);
  },
  'it casts a shadow while it is turned about z': (lights) => {
    lights[8].castShadow = true;
    lights[8].rotation.set(0, 1, 0.5);
  },
  'it casts none, turned as before': (lights) => {
    lights[8].castShadow = false;
    lights[8].rotation.set(0, 1, 0);
  },
  'one gets a profile or image': (lights) => (lights[9].userData.farolMap = {}),
  'one gets a range of its own': (lights) => setLightOptions(lights[10], { ambient: [1, 1, 1] }),
  'it is plain again': (lights) => (lights[10].userData = {}),
  'its matrix is written by hand': (lights) => {
    lights[11].matrixAutoUpdate = false;
    lights[11].matrix.makeRotationX(1).setPosition(5, 6, 7);
    lights[11].matrixWorldNeedsUpdate = true;
  },
  'its matrix is made of its position again': (lights) => (lights[11].matrixAutoUpdate = true),
  'its world matrix is written by hand': (lights) => {
    lights[12].matrixWorldAutoUpdate = false;
    lights[12].matrixWorld.makeScale(2, 2, 2).setPosition(5, 6, 7);
  },
  'its world matrix is three’s again': (lights) => (lights[12].matrixWorldAutoUpdate = true),
  'a matrix that three makes is written over': (lights) => lights[13].matrix.makeRotationY(2),
  'a world matrix that three makes is written over': (lights) => lights[13].matrixWorld.makeScale(3, 3, 3),
  'a matrix is replaced': (lights) => (lights[13].matrix = new Matrix4().makeScale(0, 0, 0)),
  'a turn is applied': (lights) => lights[14].applyMatrix4(new Matrix4().makeRotationX(1)),
  'a pivot is set': (lights) => Object.assign(lights[15], { pivot: new Vector3(1, 2, 3) }).rotation.set(1, 1, 1),
  'its pivot is moved': (lights) => (lights[15] as PointLight & { pivot: Vector3 }).pivot.set(3, 3, 3),
  'one gets a child': (lights) => lights[16].add(new Mesh()),
  'one moves to a group': (lights, group) => group.add(lights[17]),
  'the group moves': (_, group) => group.position.set(-4, 0, 0),
  'it comes back': (lights, _, scene) => scene.add(lights[17]),
  'one is removed': (lights) => lights[0].removeFromParent(),
  'it is added again': (lights, _, scene) => scene.add(lights[0]),
  'the order changes': (_lights, _group, { children }) => children.reverse(),
  'one makes its matrix itself': (lights) => {
    lights[18].updateMatrix = () => lights[18].matrix.makeTranslation(8, 8, 8);
  },
  'the scene moves': (_lights, _group, scene) => scene.position.set(0, 1, 0),
  'the scene moves back': (_lights, _group, scene) => scene.position.set(0, 0, 0),
  'all are moved in the end': (lights) => lights.forEach(({ position }, i) => position.set(i, i, i)),
};

beforeAll(readLightsInRows);

it('reads lights and makes their matrices as three does, whatever the host has changed', () => {
  const ours = makeScene();
  const threes = makeScene();
  const found = new FoundLights();
  for (const [name, change] of Object.entries({ 'at first': () => undefined, ...changes })) {
    for (const { lights, group, scene } of [ours, threes]) (change as Change)(lights, group, scene);
    threes.scene.updateMatrixWorld();
    collectLights(ours.scene, new Camera(), left, found, true);
    const expected = new FoundLights();
    const { reader } = fetching;
    fetching.reader = null;
    collectLights(threes.scene, new Camera(), left, expected);
    fetching.reader = reader;
    const indices = ({ all }: FoundLights, { lights }: typeof ours) =>
      all.map((light) => lights.indexOf(light as PointLight));
    expect(indices(found, ours), name).toEqual(indices(expected, threes));
    expect([found.rest.length, found.nested.length], name).toEqual([expected.rest.length, expected.nested.length]);
    const numbers = new Float64Array(POINT);
    expected.all.forEach((light, i) => {
      const isPlain = readPoint(light, numbers, 0);
      const read = found.points.subarray(i * POINT, (i + 1) * POINT);
      if (isPlain) expect([...read], `${name}: light ${i}`).toEqual([...numbers]);
      else expect(read[7], `${name}: light ${i}`).toBeNaN();
    });
    ours.lights.forEach((light, i) => {
      const other = threes.lights[i];
      // a NaN position makes three's matrices NaN too
      if (Number.isNaN(light.position.x)) return;
      expect(light.matrix.elements, `${name}: matrix of light ${i}`).toEqual(other.matrix.elements);
      expect(light.matrixWorld.elements, `${name}: world matrix of light ${i}`).toEqual(other.matrixWorld.elements);
      expect(light.matrixWorldNeedsUpdate, name).toBe(false);
    });
  }
});
