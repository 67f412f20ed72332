import type { Camera, Light, Object3D, Scene, WebGLShadowMap } from 'three';

/**
 * What takes the place of three's `shadowMap.render` while a frame is drawn: Farol's maps are drawn after three's own. Renders
 * by stock three inside the frame (three's `Reflector`, `Water` and the like, which keep maps as the frame has left them) have
 * three draw its maps too, unless the host keeps them: the frame itself did not.
 * @param view the scene as the frame shows it to three
 * @param draw draws Farol's
 */
export function wrapShadowMap(shadowMap: WebGLShadowMap, view: Object3D, draw: () => void): WebGLShadowMap['render'] {
  const { render, autoUpdate } = shadowMap;
  return (lights: Light[], scene: Scene, camera: Camera) => {
    const updates = shadowMap.autoUpdate;
    if (scene !== view) shadowMap.autoUpdate = autoUpdate;
    render.call(shadowMap, lights, scene, camera);
    shadowMap.autoUpdate = updates;
    if (scene === view) draw();
  };
}
