/** OrbitControls, TransformControls and CSS2DRenderer over a picture by Farol. */
import { FarolRenderer } from '@farol/renderer';
import { WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import { CSS2DObject, CSS2DRenderer } from 'three/addons/renderers/CSS2DRenderer.js';
import { examplePage } from '../shared/examplePage';
import { lanterns } from '../shared/lanterns';

const webgl = new WebGLRenderer();
document.body.append(webgl.domElement);
const { scene, camera, knot } = lanterns();
const farol = new FarolRenderer(webgl);

const orbit = new OrbitControls(camera, webgl.domElement);
orbit.target.set(0, 1.4, 0);
orbit.update();

const gizmo = new TransformControls(camera, webgl.domElement);
gizmo.attach(knot);
gizmo.addEventListener('dragging-changed', ({ value }) => (orbit.enabled = !value));
scene.add(gizmo.getHelper());

const labels = new CSS2DRenderer();
labels.domElement.style.cssText = 'position: fixed; inset: 0; pointer-events: none';
document.body.append(labels.domElement);
const label = document.createElement('span');
label.className = 'label';
label.textContent = 'knot';
label.style.cssText = 'padding: 2px 6px; border-radius: 4px; background: #000a';
const tag = new CSS2DObject(label);
tag.position.y = 1.4;
knot.add(tag);

examplePage({
  webgl,
  farol,
  frame(byFarol) {
    if (byFarol) farol.render(scene, camera);
    else webgl.render(scene, camera);
    labels.render(scene, camera);
  },
  resize(width, height) {
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    labels.setSize(width, height);
  },
});
