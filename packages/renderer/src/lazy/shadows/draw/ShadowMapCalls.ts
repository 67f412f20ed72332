import type { Camera, Light, Object3D, Scene, WebGLRenderer, WebGLShadowMap } from 'three';

/**
 * Takes the place of three's `shadowMap.render` while a frame is drawn: Farol's maps are drawn after three's own. Renders by
 * stock three inside the frame (three's `Reflector`, `Water` and the like, which keep maps as the frame has left them) have
 * three draw its maps too, unless the host keeps them: the frame itself did not.
 */
export class ShadowMapCalls {
  private view: Object3D | null = null;
  /** Another one once a lost context is restored. */
  private shadowMap: WebGLShadowMap;
  private own: WebGLShadowMap['render'];
  private autoUpdate = true;
  private fail!: (error: unknown) => void;

  /** @param draw draws Farol's */
  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly draw: () => void,
  ) {
    this.shadowMap = webgl.shadowMap;
    this.own = webgl.shadowMap.render;
  }

  /**
   * @param view the scene as the frame shows it to three
   * @param fail gets an exception in the frame's own maps
   */
  begin(view: Object3D, fail: (error: unknown) => void): void {
    const { shadowMap } = this.webgl;
    this.view = view;
    this.fail = fail;
    this.shadowMap = shadowMap;
    this.own = shadowMap.render;
    this.autoUpdate = shadowMap.autoUpdate;
    shadowMap.render = this.render;
  }

  end(): void {
    this.shadowMap.render = this.own;
  }

  private readonly render = (lights: Light[], scene: Scene, camera: Camera) => {
    const { shadowMap, webgl } = this;
    if (scene === this.view) {
      const target = webgl.getRenderTarget();
      const face = webgl.getActiveCubeFace();
      const level = webgl.getActiveMipmapLevel();
      try {
        this.own.call(shadowMap, lights, scene, camera);
        this.draw();
      } catch (error) {
        webgl.setRenderTarget(target, face, level);
        this.fail(error);
      }
      return;
    }
    const updates = shadowMap.autoUpdate;
    shadowMap.autoUpdate = this.autoUpdate;
    try {
      this.own.call(shadowMap, lights, scene, camera);
    } finally {
      shadowMap.autoUpdate = updates;
    }
  };
}
