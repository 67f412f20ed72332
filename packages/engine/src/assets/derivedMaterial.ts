import { Material } from 'three';

/**
 * A material that inherits all properties of another one, live, but for the given values; it has a program cache and
 * listeners of its own. The source is not changed.
 */
export function derivedMaterial(source: Material, values: Readonly<Record<string, unknown>>): Material {
  const material = Object.create(source) as Material;
  const own = (name: string, value: unknown): void => {
    Object.defineProperty(material, name, { value, writable: true, configurable: true, enumerable: true });
  };
  Object.defineProperty(material, 'id', { value: new Material().id });
  Object.defineProperty(material, 'version', {
    get: () => source.version,
    // three raises `version` when it switches the side of a transparent material: this must not reach the source
    set() {},
  });
  own('_listeners', undefined);
  for (const name in values) own(name, values[name]);
  return material;
}

/** Source of a derived material (see `derivedMaterial`); any other material is returned itself. */
export function sourceOfMaterial(material: Material): Material {
  const above = Object.getPrototypeOf(material) as Material;
  return Object.hasOwn(above, 'id') ? sourceOfMaterial(above) : material;
}
