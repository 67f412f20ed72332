import { Camera, GameObject, Light, Scene, scenes } from '@farol/engine';
import type { Action } from './Action';

/** A scene to begin with: a camera and a sun. */
export const newScene: Action = {
  id: 'file.new',
  label: 'Empty scene',
  async run(editor) {
    if (!(await editor.mayLoseChanges())) return;
    const scene = new Scene({ name: 'Untitled', assets: editor.document.assets });
    const camera = new GameObject('Camera');
    camera.addComponent(Camera);
    camera.transform.lookAt([4, 3, 6], [0, 0.5, 0]);
    const sun = new GameObject('Sun');
    sun.addComponent(Light, { type: 'directional', intensity: 2 });
    sun.transform.lookAt([6, 8, 4], [0, 0, 0]);
    const sky = new GameObject('Sky');
    sky.addComponent(Light, { type: 'hemisphere', intensity: 0.4 });
    sky.transform.position = [0, 5, 0];
    for (const object of [camera, sun, sky]) scene.add(object);
    editor.show(scene, { name: null, handle: null });
  },
};

/** One action for each scene of the engine's. */
export const openExamples: readonly Action[] = Object.values(scenes).map(({ name, label }) => ({
  id: `file.new.${name}`,
  label,
  async run(editor) {
    if (await editor.mayLoseChanges()) await editor.openScene(name);
  },
}));
