import {
  AudioSource,
  Camera,
  Decal,
  FogVolume,
  type GameObject,
  Light,
  LightGroup,
  ModelRenderer,
  ObjectRenderer,
  Room,
  Wall,
} from '@farol/engine';
import { isInstanceRoot } from '@farol/engine/prefabs';
import type { IconName } from '../../style/iconPaths';

/** Icon for a GameObject, by its kind or its components. */
export function objectIcon(object: GameObject): IconName {
  if (isInstanceRoot(object)) return 'prefab';
  const light = object.getComponent(Light);
  if (light) return light.type;
  if (object.getComponent(LightGroup)) return 'sliders';
  if (object.getComponent(Camera)) return 'camera';
  if (object.getComponent(Room)) return 'room';
  if (object.getComponent(Wall)) return 'wall';
  if (object.getComponent(ObjectRenderer) || object.getComponent(ModelRenderer)) return 'mesh';
  if (object.getComponent(Decal)) return 'decal';
  if (object.getComponent(FogVolume)) return 'fog';
  if (object.getComponent(AudioSource)) return 'sound';
  return object.children.length > 0 ? 'folder' : 'object';
}
