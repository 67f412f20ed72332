/** A glTF file by GLTFLoader, with its lights, skins and animations, under an environment map. */
import { FarolRenderer } from '@farol/renderer';
import { AnimationMixer, Color, PerspectiveCamera, PMREMGenerator, Scene, WebGLRenderer } from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { examplePage } from '../shared/examplePage';

const webgl = new WebGLRenderer();
document.body.append(webgl.domElement);
const scene = new Scene();
scene.background = new Color(0x10141c);
scene.environment = new PMREMGenerator(webgl).fromScene(new RoomEnvironment()).texture;
scene.environmentIntensity = 0.25;
const camera = new PerspectiveCamera(40, 1, 0.1, 50);
camera.position.set(0.6, 1.9, 5);
camera.lookAt(0, 1.2, 0);
const farol = new FarolRenderer(webgl);

const mixer = new AnimationMixer(scene);
const load = async () => {
  const { scene: model, animations } = await new GLTFLoader().loadAsync('../../models/streetLamp.glb');
  scene.add(model);
  for (const clip of animations) mixer.clipAction(clip, model).play();
  await farol.compileAsync(scene, camera);
};

examplePage({
  webgl,
  farol,
  ready: load(),
  frame(byFarol, seconds) {
    mixer.setTime(seconds);
    if (byFarol) farol.render(scene, camera);
    else webgl.render(scene, camera);
  },
  resize(width, height) {
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  },
});
