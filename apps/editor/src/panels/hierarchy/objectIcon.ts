import { Camera, type GameObject, Light, ObjectRenderer } from '@farol/engine';
import type { IconName } from '../../ui/iconPaths';

/** The icon that says what a GameObject is. */
export function objectIcon(object: GameObject): IconName {
  const light = object.getComponent(Light);
  if (light) return light.type;
  if (object.getComponent(Camera)) return 'camera';
  if (object.getComponent(ObjectRenderer)) return 'mesh';
  return object.children.length > 0 ? 'folder' : 'object';
}
