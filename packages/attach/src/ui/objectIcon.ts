import type { Object3D } from 'three';
import type { IconName } from './icon';

const lights: Readonly<Record<string, IconName>> = {
  PointLight: 'point',
  SpotLight: 'spot',
  DirectionalLight: 'directional',
  AmbientLight: 'ambient',
  HemisphereLight: 'hemisphere',
  RectAreaLight: 'rectangle',
};

/** Name of the icon of a three object, equal to that of the corresponding component in Farol's own editor. */
export function objectIcon(object: Object3D): IconName {
  const kind = object as { isScene?: boolean; isMesh?: boolean; isCamera?: boolean; isGroup?: boolean };
  if (kind.isScene) return 'scene';
  if (kind.isMesh) return 'mesh';
  if (kind.isCamera) return 'camera';
  if (kind.isGroup) return 'folder';
  return lights[object.type] ?? 'object';
}
