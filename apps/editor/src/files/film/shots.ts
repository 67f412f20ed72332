import { t } from '@farol/editing';
import { Camera as CameraComponent, type Scene, type SceneView } from '@farol/engine';
import { CatmullRomCurve3, MathUtils, OrthographicCamera, PerspectiveCamera, Sphere, Vector3 } from 'three';
import type { EditorApi } from '../../api/EditorApi';
import { boundsOf } from '../../viewport/boundsOf';
import { copyEye, type Eye, shownEye } from '../picture/PictureCanvas';

/** Viewpoints of films besides the scene's cameras, each of which is named by the id of its component. */
export const shotKinds = ['shown', 'active', 'path', 'turntable'] as const;

/** Viewpoint of a film: one of `shotKinds`, or the id of a Camera. */
export type ShotName = string;

/** The camera of a frame of a film. */
interface FramedEye {
  readonly eye: Eye;
  /** Camera whose own settings apply; null for the editor's camera. */
  readonly component: CameraComponent | null;
}

/** Returns the camera of a frame. @param share - position in the film, from 0 to below 1 */
export type Shot = (share: number) => FramedEye;

/** Stored views of a scene, by ascending number. */
export const keptViews = (scene: Scene): SceneView[] => scene.views.entries.map(([, view]) => view);

/** Moves smoothly through the stored views, with equal time between them; orthographic when all of them are. */
function pathShot(views: readonly SceneView[], aspect: number): Shot {
  const curve = (points: readonly (readonly number[])[]): CatmullRomCurve3 =>
    new CatmullRomCurve3(points.map(([x, y, z]) => new Vector3(x, y, z)));
  const positions = curve(views.map(({ position }) => position));
  const targets = curve(views.map(({ target }) => target));
  const isFlat = views.every(({ orthographic }) => orthographic);
  const camera = isFlat ? new OrthographicCamera() : new PerspectiveCamera();
  const target = new Vector3();
  let eye: Eye | null = null;
  return (share) => {
    positions.getPoint(share, camera.position);
    targets.getPoint(share, target);
    camera.lookAt(target);
    const place = share * (views.length - 1);
    const i = Math.min(Math.floor(place), views.length - 2);
    const fov = MathUtils.lerp(views[i].fov, views[i + 1].fov, place - i);
    const distance = camera.position.distanceTo(target);
    camera.near = isFlat ? 0 : 0.05;
    camera.far = Math.max(1000, 20 * distance);
    if (camera instanceof PerspectiveCamera) camera.fov = fov * MathUtils.RAD2DEG;
    else {
      camera.top = distance * Math.tan(fov / 2);
      camera.bottom = -camera.top;
    }
    return { eye: (eye = copyEye(camera, aspect, eye)), component: null };
  };
}

/** Turns the current view about the vertical axis through the centre of the selection, or else of the scene. */
function turntableShot(editor: EditorApi, aspect: number, turns: number): Shot {
  const { selectedObjects, scene } = editor.document;
  const { camera, component } = shownEye(editor);
  const sphere = boundsOf(selectedObjects.length > 0 ? selectedObjects : scene.roots).getBoundingSphere(new Sphere());
  if (sphere.isEmpty()) throw new Error(t('There is nothing to turn around: add an object first.'));
  const { center } = sphere;
  const start = copyEye(camera, aspect);
  const arm = start.getWorldPosition(new Vector3()).sub(center);
  // a view from straight above has no horizontal direction to turn
  if (Math.hypot(arm.x, arm.z) < 1e-3 * arm.length() || arm.length() === 0)
    arm.set(arm.x, arm.y, arm.z + sphere.radius + 1);
  const turned = start.clone() as Eye;
  const up = new Vector3(0, 1, 0);
  let eye: Eye | null = null;
  return (share) => {
    turned.matrixAutoUpdate = true;
    turned.position
      .copy(arm)
      .applyAxisAngle(up, share * turns * 2 * Math.PI)
      .add(center);
    turned.lookAt(center);
    return { eye: (eye = copyEye(turned, aspect, eye)), component };
  };
}

/**
 * Makes the function that gives each frame's camera.
 * @param aspect - width over height
 * @param turns - revolutions of a turntable; negative: reversed
 * @throws Error when there is no such camera, too few views are stored, or there is nothing to turn around
 */
export function makeShot(editor: EditorApi, name: ShotName, aspect: number, turns: number): Shot {
  const { scene } = editor.document;
  if (name === 'path') {
    const views = keptViews(scene);
    if (views.length < 2) throw new Error(t('A path needs two stored views: Ctrl with a number stores one.'));
    return pathShot(views, aspect);
  }
  if (name === 'turntable') return turntableShot(editor, aspect, turns);
  let eye: Eye | null = null;
  if (name === 'shown') {
    const { camera, component } = shownEye(editor);
    return () => ({ eye: (eye = copyEye(camera, aspect, eye)), component });
  }
  const find = (): CameraComponent | null => {
    const found = name === 'active' ? scene.activeCamera : scene.findComponentById(name);
    return found instanceof CameraComponent ? found : null;
  };
  let component = find();
  if (!component) throw new Error(t('The scene has no such camera any more: choose another one.'));
  return () => {
    // after a script has removed the camera, its last pose is used
    component = find() ?? component!;
    if (component.isAttached || eye === null) eye = copyEye(component.three, aspect, eye);
    return { eye, component };
  };
}
