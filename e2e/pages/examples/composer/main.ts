/** three's EffectComposer, drawn by Farol. */
import { FarolRenderer } from '@farol/renderer';
import { FarolPass } from '@farol/renderer/three-pass';
import { ACESFilmicToneMapping, Vector2, WebGLRenderer } from 'three';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { RenderPass } from 'three/addons/postprocessing/RenderPass.js';
import { UnrealBloomPass } from 'three/addons/postprocessing/UnrealBloomPass.js';
import { examplePage } from '../shared/examplePage';
import { lanterns } from '../shared/lanterns';

const webgl = new WebGLRenderer();
webgl.toneMapping = ACESFilmicToneMapping;
document.body.append(webgl.domElement);
const { scene, camera, update } = lanterns();

const farol = new FarolRenderer(webgl);
const farolPass = new FarolPass(farol, scene, camera); // in place of: new RenderPass(scene, camera)
const stockPass = new RenderPass(scene, camera); // only here to compare with

const composer = new EffectComposer(webgl);
composer.addPass(farolPass);
composer.addPass(stockPass);
composer.addPass(new UnrealBloomPass(new Vector2(256, 256), 0.4, 0.3, 1));
composer.addPass(new OutputPass());

examplePage({
  webgl,
  farol,
  frame(byFarol, seconds) {
    update(seconds);
    farolPass.enabled = byFarol;
    stockPass.enabled = !byFarol;
    composer.render();
  },
  resize(width, height) {
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    composer.setSize(width, height);
  },
});
