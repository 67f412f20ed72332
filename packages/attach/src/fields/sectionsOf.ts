import { t } from '@farol/editing';
import type { Camera, Light, Material, Mesh, Object3D } from 'three';
import { cameraProperties } from './cameraProperties';
import { lightProperties } from './lightProperties';
import { materialProperties } from './materialProperties';
import { objectProperties, transformProperties } from './objectProperties';
import { type Property, PropertyOwner } from './Property';

/** Properties under one heading of the inspector. */
export interface Section {
  readonly title: string;
  /** Objects or materials with these properties: at least one; all have the same fields. */
  readonly owners: readonly PropertyOwner[];
}

const materialsOf = (object: Object3D): Material[] => {
  const { material } = object as Mesh;
  return [...new Set<Material>(Array.isArray(material) ? material : material ? [material] : [])];
};

/**
 * Sections of the inspector for selected objects: transform, flags, and properties of lights, cameras or materials.
 * Several objects get the sections that all of them have.
 * @param objects - at least one
 */
export function sectionsOf(objects: readonly Object3D[]): Section[] {
  const [first] = objects;
  const types = new Set(objects.map(({ type }) => type));
  const title = (common: string): string => (types.size === 1 ? first.type : common);
  const sections = [
    section(t('Transform'), objects, transformProperties),
    section(t('Object'), objects, objectProperties),
  ];
  if (objects.every((object) => (object as Light).isLight))
    sections.push(section(title(t('Light')), objects, lightProperties));
  if (objects.every((object) => (object as Camera).isCamera))
    sections.push(section(title(t('Camera')), objects, cameraProperties));
  const materials = objects.map(materialsOf);
  const all = [...new Set(materials.flat())];
  if (objects.length === 1) {
    for (const each of all) {
      sections.push(section(each.name ? `${each.type} ${each.name}` : each.type, [each], materialProperties));
    }
  } else if (materials.every((list) => list.length > 0)) {
    const label = all.length === 1 ? all[0].type : t('{count} materials', { count: all.length });
    sections.push(section(label, all, materialProperties));
  }
  return sections.filter(({ owners }) => Object.keys(owners[0].fields).length > 0);
}

function section(
  title: string,
  targets: readonly (Object3D | Material)[],
  properties: readonly Property<Record<string, unknown>>[],
): Section {
  const values = targets as readonly unknown[] as readonly Record<string, unknown>[];
  const present = properties.filter(({ name }) =>
    values.every((each) => each[name] !== undefined && each[name] !== null),
  );
  return { title, owners: targets.map((each) => new PropertyOwner(each.name || each.type, each, present)) };
}
