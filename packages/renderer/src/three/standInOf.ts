/**
 * A live stand-in of an object: it inherits all that the object has, and gets properties of its own in place of some.
 * Accessors run on the object itself: a host's class may keep what they give in private fields, which a stand-in has not.
 * @param base prototype of three's, whose own accessors and what they read stand-ins may replace
 */
export function standInOf<T extends object>(source: T, base: object): T {
  const standIn = Object.create(source) as T;
  for (let one: object | null = source; one && one !== base; one = Object.getPrototypeOf(one) as object | null) {
    const properties = Object.getOwnPropertyDescriptors(one);
    for (const name in properties) {
      const { get, set } = properties[name as keyof typeof properties] as PropertyDescriptor;
      if (!get) continue;
      Object.defineProperty(standIn, name, {
        get: () => source[name as keyof T],
        set: set && ((value) => (source[name as keyof T] = value)),
        configurable: true,
      });
    }
  }
  return standIn;
}
