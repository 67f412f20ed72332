import type { FieldValue } from '@farol/editing/fields';
import { Light } from '../components/Light';
import { LightGroup } from '../components/LightGroup';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import { skyFields } from '../settings/pictureFields';
import { type BakeSources, bakeSources } from './bakeSources';

/** Names of fields that have no effect on baked light, by component type. */
const without: Readonly<Record<string, readonly string[]>> = {
  ObjectRenderer: ['receiveShadow'],
  ModelRenderer: ['receiveShadow', 'animation', 'animationSpeed'],
  Light: [
    ...['shadowMapSize', 'shadowRadius', 'shadowBias', 'shadowNormalBias', 'shadowExtent'],
    ...['intensityUnit', 'lamp', 'group'],
  ],
};

/**
 * Omits fields of a Light that older bakes did not have if the light does not use them, so that those bakes stay valid.
 */
function withoutUnused(light: Light, values: Record<string, FieldValue>): void {
  if (light.colourBy === 'temperature') return;
  delete values.colourBy;
  delete values.kelvin;
}

/** Master of a light's group; '' for none. */
function masterOf({ group, scene }: Light): string {
  const master = group === null ? null : scene?.findById(group)?.getComponent(LightGroup);
  return master ? JSON.stringify([master.isActive, master.authoredValues()]) : '';
}

/** Text of a number, equal for numbers that differ by rounding errors alone. */
const rounded = (value: number): string => (Math.abs(value) < 5e-6 ? '0' : value.toFixed(5));

function placeOf({ object3D }: GameObject): string {
  object3D.updateWorldMatrix(true, false);
  return object3D.matrixWorld.elements.map(rounded).join(' ');
}

/**
 * Hash of all that a bake made now would depend on: static objects, baked lights, materials and places, and the sky
 * where it is baked. A bake with another hash is out of date. The quality of the bake is not included.
 */
export function bakeSignature(scene: Scene, sources: BakeSources = bakeSources(scene)): string {
  const { settings, assets } = scene;
  const components = [...new Set(sources.meshes.map(({ component }) => component)), ...sources.lights];
  const materials = new Set<string>();
  const texts = components.map((component) => {
    const values = component.authoredValues();
    for (const name of without[component.typeName] ?? []) delete values[name];
    if (component instanceof Light) withoutUnused(component, values);
    if (typeof values.material === 'string') materials.add(values.material);
    const shapes = component.gameObject.components.filter((each) => each.enabled && 'shapeGeometry' in each);
    const shape = shapes.map((each) => JSON.stringify(each.authoredValues())).join('');
    return `${component.id} ${placeOf(component.gameObject)} ${JSON.stringify(values)}${shape}${component instanceof Light ? masterOf(component) : ''}`;
  });
  for (const name of materials)
    texts.push(`${name} ${JSON.stringify(assets.materialAsset(name)?.changedValues() ?? null)}`);
  if (settings.bakeSky) {
    const names = Object.keys(skyFields).filter((name) => name !== 'backgroundBlur' && name !== 'backgroundIntensity');
    texts.push(JSON.stringify(names.map((name) => settings.getAuthored(name))));
  }
  return hashOf(texts.toSorted().join('\n'));
}

/** 53-bit hash of a text, 14 hexadecimal digits. bryc, cyrb53 */
function hashOf(text: string): string {
  let a = 0xdeadbeef;
  let b = 0x41c6ce57;
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    a = Math.imul(a ^ code, 2654435761);
    b = Math.imul(b ^ code, 1597334677);
  }
  a = Math.imul(a ^ (a >>> 16), 2246822507) ^ Math.imul(b ^ (b >>> 13), 3266489909);
  b = Math.imul(b ^ (b >>> 16), 2246822507) ^ Math.imul(a ^ (a >>> 13), 3266489909);
  return (4294967296 * (2097151 & b) + (a >>> 0)).toString(16).padStart(14, '0');
}
