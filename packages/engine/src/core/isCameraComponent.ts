import type { CameraComponent, Component } from './SceneGraph';

/** Whether a scene can be drawn through a component. */
export const isCameraComponent = (component: Component): component is CameraComponent => 'setViewport' in component;
