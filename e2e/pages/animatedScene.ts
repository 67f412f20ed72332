import {
  Animation,
  type ClipData,
  clipText,
  GameObject,
  Model,
  ModelRenderer,
  ObjectRenderer,
  Scene,
} from '@farol/engine';
import * as THREE from 'three';
import { bentPole } from './edgeScene';

/** How long the clips are (s). */
const LENGTH = 2;

/** A scene of the engine's whose objects are moved by components Animation. */
export interface AnimatedScene {
  readonly scene: THREE.Scene;
  readonly camera: THREE.Camera;
  /** By what is moved: an object by its Transform, a part of a model by its node, a skin by a bone. */
  readonly movers: Readonly<Record<'object' | 'node' | 'skin', THREE.Object3D>>;
  /** Puts the clips at a time (s), from 0 to `LENGTH`. */
  setTime(seconds: number): void;
}

const turned = (x: number, y: number, z: number): number[] =>
  new THREE.Quaternion().setFromEuler(new THREE.Euler(x, y, z)).toArray();

/** A model of a pole that its clip bends, and a plate that its clip turns, as imported ones are. */
function poleModel(): Model {
  const white = new THREE.MeshStandardMaterial({ color: 0xdddddd, roughness: 0.9 });
  const root = new THREE.Group();
  const pole = bentPole(white);
  pole.name = 'Pole';
  pole.skeleton.bones[1].name = 'Tip';
  pole.position.set(-1.6, 0.6, 0);
  const plate = new THREE.Mesh(new THREE.BoxGeometry(1.4, 0.3, 0.3), white);
  plate.name = 'Plate';
  plate.position.set(1.6, 0.6, 0);
  root.add(pole, plate);
  return new Model(root, [
    new THREE.AnimationClip('Bend', LENGTH, [
      new THREE.QuaternionKeyframeTrack('Tip.quaternion', [0, LENGTH], [0, 0, 0, 1, ...turned(0, 0, 1.6)]),
      new THREE.QuaternionKeyframeTrack('Plate.quaternion', [0, LENGTH], [0, 0, 0, 1, ...turned(0, 0, 2)]),
    ]),
  ]);
}

/** Waits for nothing: its assets are made here. */
export function animatedScene(width: number, height: number): AnimatedScene {
  const scene = new Scene();
  scene.onComponentError = (_component, error) => console.error(error);
  const { assets } = scene;
  const model = poleModel();
  assets.register('pole.glb', model).register('pole.glb/Bend', model.clips[0]);
  const keys = (from: readonly number[], to: readonly number[]) => [
    { time: 0, value: from as never },
    { time: LENGTH, value: to as never },
  ];
  const data: ClipData = {
    tracks: [
      { path: 'Arm', component: 'Transform', field: 'position', keys: keys([-0.8, -0.6, 0], [0.8, 0.4, 0]) },
      { path: 'Arm', component: 'Transform', field: 'rotation', keys: keys([0, 0, 0], [0.5, 0.4, 2]) },
    ],
    events: [],
  };
  assets.addFieldAsset('clip', 'Swing', { data: clipText(data), duration: LENGTH });
  const machine = new GameObject('Machine');
  machine.addComponent(Animation, { clip: 'Swing', wrap: 'once' });
  const arm = new GameObject('Arm');
  arm.addComponent(ObjectRenderer, { mesh: 'box', colour: [0.8, 0.3, 0.2] });
  machine.add(arm);
  const puppet = new GameObject('Puppet');
  puppet.addComponent(ModelRenderer, { model: 'pole.glb' });
  puppet.addComponent(Animation, { clip: 'pole.glb/Bend', wrap: 'once' });
  scene.add(machine).add(puppet);
  const { three } = scene;
  three.background = new THREE.Color(0, 0, 0);
  three.add(new THREE.AmbientLight(0xffffff, 0.4));
  const sun = new THREE.DirectionalLight(0xffffff, 1.6);
  sun.position.set(2, 4, 3);
  three.add(sun);
  const camera = new THREE.PerspectiveCamera(40, width / height, 0.1, 60);
  camera.position.set(0, 0.5, 7);
  const named = (name: string): THREE.Object3D => puppet.object3D.getObjectByName(name)!;
  return {
    scene: three,
    camera,
    movers: { object: arm.object3D, node: named('Plate'), skin: named('Pole') },
    setTime: (seconds) => scene.setTime(seconds),
  };
}
