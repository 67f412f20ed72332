import type { OrthographicCamera, PerspectiveCamera } from 'three';
import type { Component } from './Component';

/** A component that a scene can be drawn through: `Camera`, or any other with these members. */
export interface CameraComponent extends Component {
  /** The camera to draw with, below the object's object3D. */
  readonly three: PerspectiveCamera | OrthographicCamera;
  /** Called before each frame with the canvas's size, in any unit, for the aspect ratio; does not count as an edit. */
  setViewport(width: number, height: number): void;
}

/** Whether a scene can be drawn through a component. */
export const isCameraComponent = (component: Component): component is CameraComponent => 'setViewport' in component;
