/** three's stats panel, and stats-gl, which times every `webgl.render` on the GPU: Farol draws within one. */
import { FarolRenderer } from '@farol/renderer';
import StatsGL from 'stats-gl';
import { WebGLRenderer } from 'three';
import Stats from 'three/addons/libs/stats.module.js';
import { examplePage } from '../shared/examplePage';
import { lanterns } from '../shared/lanterns';

const webgl = new WebGLRenderer();
document.body.append(webgl.domElement);
const { scene, camera, update } = lanterns();

// GPU timer queries cannot be nested: while stats-gl times the GPU, Farol's own `timing` has no figures.
const farol = new FarolRenderer(webgl);

const stats = new Stats();
stats.dom.style.cssText = 'position: fixed; right: 0; bottom: 0';
document.body.append(stats.dom);

const statsGL = new StatsGL({ trackGPU: true });
Object.assign(statsGL.dom.style, { top: 'auto', bottom: '48px' });
document.body.append(statsGL.dom);

const calls = document.createElement('output');
document.querySelector('nav')!.append(calls);

examplePage({
  webgl,
  farol,
  ready: statsGL.init(webgl),
  frame(byFarol, seconds) {
    stats.begin();
    update(seconds);
    if (byFarol) farol.render(scene, camera);
    else webgl.render(scene, camera);
    stats.end();
    statsGL.update();
    calls.value = `${webgl.info.render.calls} draw calls`;
  },
  resize(width, height) {
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  },
});
