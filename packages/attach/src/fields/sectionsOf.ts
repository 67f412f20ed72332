import type { Camera, Light, Material, Mesh, Object3D } from 'three';
import { cameraProperties } from './cameraProperties';
import { lightProperties } from './lightProperties';
import { materialProperties } from './materialProperties';
import { objectProperties, transformProperties } from './objectProperties';
import { bind, type BoundProperty, type Property } from './Property';

/** Properties under one heading of the inspector. */
export interface Section {
  readonly title: string;
  readonly properties: readonly BoundProperty[];
}

/** What the inspector shows of an object: its transform, its flags, and what it has as light, camera or by its materials. */
export function sectionsOf(object: Object3D): Section[] {
  const sections = [section('Transform', object, transformProperties), section('Object', object, objectProperties)];
  if ((object as Light).isLight === true) sections.push(section(object.type, object, lightProperties));
  if ((object as Camera).isCamera === true) sections.push(section(object.type, object, cameraProperties));
  const { material } = object as Mesh;
  for (const each of new Set<Material>(Array.isArray(material) ? material : material ? [material] : [])) {
    sections.push(section(each.name ? `${each.type} ${each.name}` : each.type, each, materialProperties));
  }
  return sections.filter(({ properties }) => properties.length > 0);
}

function section(title: string, target: object, properties: readonly Property<Record<string, unknown>>[]): Section {
  const own = target as Record<string, unknown>;
  const present = properties.filter(({ name }) => own[name] !== undefined && own[name] !== null);
  return { title, properties: bind(own, present) };
}
