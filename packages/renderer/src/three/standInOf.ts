/**
 * Makes a live stand-in for an object: it inherits all properties, and the caller may override some. Accessors run on the object
 * itself, since a host's class may use private fields, which a stand-in lacks.
 * @param base - prototype of three's, whose accessors run on the stand-in
 */
export function standInOf<T extends object>(source: T, base: object): T {
  const standIn = Object.create(source) as T;
  for (let one: object | null = source; one && one !== base; one = Object.getPrototypeOf(one) as object | null) {
    for (const [name, { get }] of Object.entries(Object.getOwnPropertyDescriptors(one))) {
      if (!get) continue;
      const key = name as keyof T;
      Object.defineProperty(standIn, name, {
        get: () => source[key],
        set(value) {
          source[key] = value;
        },
        configurable: true,
      });
    }
  }
  return standIn;
}
