import type { GameObject, Scene } from '@farol/engine';
import { creations } from '../model/creations';

/** Entries of the Add menu by names that are the same in all languages, such as 'empty', 'Point light' and 'box'. */
export function creationNames({ registry, assets }: Scene): {
  readonly names: readonly string[];
  /** @throws Error (as a rejection) for an unknown name; it lists alike ones */
  make(name: string): Promise<GameObject>;
} {
  // in the order of `creations`, whose labels are in the language that is shown
  const names = [
    'empty',
    ...[...registry.types.values()].flatMap((type) =>
      Object.hasOwn(type, 'newObjects') ? type.newObjects.map(({ label }) => label) : [],
    ),
    ...assets.list('mesh'),
  ];
  return {
    names,
    async make(name) {
      const asked = name.toLowerCase();
      const index = names.findIndex((each) => each.toLowerCase() === asked);
      if (index < 0) {
        const alike = names.filter((each) => each.toLowerCase().includes(asked) || asked.includes(each.toLowerCase()));
        throw new Error(
          `Nothing is called “${name}”${alike.length > 0 ? `; there is ${alike.slice(0, 5).join(', ')}` : ''}. describe_type lists all.`,
        );
      }
      return creations({ registry, assets } as Scene)[index].make();
    },
  };
}
