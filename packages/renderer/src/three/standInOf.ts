/**
 * A live stand-in of an object: it inherits all that the object has, and gets properties of its own in place of some.
 * Accessors run on the object itself: a host's class may keep what they give in private fields, which a stand-in has not.
 * @param base - prototype of three's, whose own accessors and what they read stand-ins may replace
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
