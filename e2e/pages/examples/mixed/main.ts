/** A page that draws by stock `webgl.render` before and after Farol, with the same scene and the same materials. */
import { FarolRenderer } from '@farol/renderer';
import {
  AxesHelper,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  SRGBColorSpace,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { examplePage } from '../shared/examplePage';
import { lanterns } from '../shared/lanterns';

const webgl = new WebGLRenderer();
document.body.append(webgl.domElement);
const { scene, camera, update } = lanterns();
const farol = new FarolRenderer(webgl);

// a screen within the scene shows the scene from above
const above = new WebGLRenderTarget(256, 256);
above.texture.colorSpace = SRGBColorSpace;
const aboveCamera = new PerspectiveCamera(50, 1, 0.1, 60);
aboveCamera.position.set(0, 14, 0.01);
aboveCamera.lookAt(0, 0, 0);
const screen = new Mesh(new PlaneGeometry(2.4, 2.4), new MeshBasicMaterial({ map: above.texture }));
screen.position.set(-3.2, 2, -1.5);
screen.rotation.y = 0.6;
scene.add(screen);

// an overlay over the finished picture
const overlay = new Scene();
const overlayCamera = new OrthographicCamera(-1.5, 10, 10, -1.5, -10, 10);
const axes = new AxesHelper(1);
overlay.add(axes);

examplePage({
  webgl,
  farol,
  frame(byFarol, seconds) {
    update(seconds);
    webgl.setRenderTarget(above);
    screen.visible = false;
    webgl.render(scene, aboveCamera);
    screen.visible = true;
    webgl.setRenderTarget(null);

    if (byFarol) farol.render(scene, camera);
    else webgl.render(scene, camera);

    webgl.autoClear = false;
    webgl.clearDepth();
    axes.quaternion.copy(camera.quaternion).invert();
    webgl.render(overlay, overlayCamera);
    webgl.autoClear = true;
  },
  resize(width, height) {
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    overlayCamera.right = overlayCamera.left + (11.5 * width) / height;
    overlayCamera.updateProjectionMatrix();
  },
});
