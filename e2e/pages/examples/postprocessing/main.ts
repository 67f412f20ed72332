/** pmndrs' postprocessing, drawn by Farol. */
import { FarolRenderer } from '@farol/renderer';
import { FarolPostPass } from '@farol/renderer/postprocessing';
import {
  BloomEffect,
  DepthOfFieldEffect,
  EffectComposer,
  EffectPass,
  RenderPass,
  ToneMappingEffect,
  ToneMappingMode,
} from 'postprocessing';
import { HalfFloatType, WebGLRenderer } from 'three';
import { examplePage } from '../shared/examplePage';
import { lanterns } from '../shared/lanterns';

const webgl = new WebGLRenderer({ powerPreference: 'high-performance', stencil: false, depth: false });
document.body.append(webgl.domElement);
const { scene, camera, update } = lanterns();

const farol = new FarolRenderer(webgl);
const farolPass = new FarolPostPass(farol, scene, camera); // in place of: new RenderPass(scene, camera)
const stockPass = new RenderPass(scene, camera); // only here to compare with

const composer = new EffectComposer(webgl, { frameBufferType: HalfFloatType });
composer.addPass(farolPass);
composer.addPass(stockPass);
composer.addPass(
  new EffectPass(camera, new DepthOfFieldEffect(camera, { focusDistance: 8, focusRange: 4, bokehScale: 2 })),
);
composer.addPass(
  new EffectPass(
    camera,
    new BloomEffect({ intensity: 1.2, luminanceThreshold: 1 }),
    new ToneMappingEffect({ mode: ToneMappingMode.ACES_FILMIC }),
  ),
);

examplePage({
  webgl,
  farol,
  frame(byFarol, seconds) {
    update(seconds);
    farolPass.enabled = byFarol;
    stockPass.enabled = !byFarol;
    composer.render(1 / 60);
  },
  resize(width, height) {
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    composer.setSize(width, height);
  },
});
