import { CharacterController, Collider, Joint, type GameObject } from '@farol/engine';
import { Object3D, type Vector3 } from 'three';
import { type Handle, type HandleHost, HandlePoints } from '../handles/HandlePoints';
import { LineSet } from '../LineSet';
import { drawCollider } from './colliderLines';
import { drawCharacter, drawJoint } from './jointLines';
import { colliderHandles, jointHandles } from './shapeHandles';

/** Colour of lines for selected objects. */
const COLOUR = '#63e28a';
/** Colour of lines for other objects. */
const QUIET = '#3f8f5a';

/** The part of the viewport that the overlay uses. */
export interface OverlayHost extends HandleHost {
  /** Whether colliders of all objects are drawn, or only of selected ones. */
  readonly showColliders: boolean;
}

/** Colliders, joints and characters as lines, and handles that resize and move those of the selected object. */
export class PhysicsOverlay {
  readonly three = new Object3D();

  private readonly selected = new LineSet(COLOUR);
  private readonly others = new LineSet(QUIET);
  private readonly handles: HandlePoints;
  private othersKey = 'none';

  constructor(private readonly host: OverlayHost) {
    this.handles = new HandlePoints(host, COLOUR, handlesOf);
    this.three.add(this.others.three, this.selected.three, this.handles.three);
  }

  /** World positions of the handles, for tests. */
  get places(): readonly Vector3[] {
    return this.handles.places;
  }

  /** Updates the lines and handles for a frame. @param pixelRatio - pixel ratio of the canvas */
  update(pixelRatio: number): void {
    const { document, showColliders } = this.host;
    const { scene, selectedObjects } = document;
    this.selected.begin();
    for (const object of selectedObjects) drawObject(this.selected, object);
    this.selected.end();
    const key = showColliders ? `${document.edited.revision} ${document.selection.changed.revision} ${scene.time}` : '';
    if (key !== this.othersKey) {
      this.othersKey = key;
      const chosen = new Set(document.selection.ids);
      this.others.begin();
      if (showColliders) {
        const show = ({ gameObject }: Collider): boolean => !chosen.has(gameObject.id) && gameObject.activeInHierarchy;
        for (const each of scene.componentsOf(Collider)) if (show(each)) drawCollider(this.others, each);
        for (const each of scene.componentsOf(Joint)) if (!chosen.has(each.gameObject.id)) drawJoint(this.others, each);
        for (const each of scene.componentsOf(CharacterController)) {
          if (!chosen.has(each.gameObject.id)) drawCharacter(this.others, each);
        }
      }
      this.others.end();
    }
    this.handles.update(pixelRatio);
  }

  dispose(): void {
    this.handles.dispose();
    this.selected.dispose();
    this.others.dispose();
  }
}

function drawObject(lines: LineSet, object: GameObject): void {
  for (const component of object.components) {
    if (component instanceof Collider) drawCollider(lines, component);
    else if (component instanceof Joint) drawJoint(lines, component);
    else if (component instanceof CharacterController) drawCharacter(lines, component);
  }
}

const handlesOf = (object: GameObject): Handle[] =>
  object.components.flatMap((component) =>
    component instanceof Collider
      ? colliderHandles(component)
      : component instanceof Joint
        ? jointHandles(component)
        : [],
  );
