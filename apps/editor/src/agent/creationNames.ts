import type { GameObject, Scene } from '@farol/engine';
import { creations } from '../model/creations';
import { libraryNames } from '../model/library/names';

const { lamp, prop, play, sky } = libraryNames;
/** Ids of the library's lamps, props and behaviours, and of its skies, by their English names. */
const library = new Map<string, string>(
  [lamp, prop, play, sky].flatMap((names) =>
    Object.entries(names).map(([id, name]): [string, string] => [name.replace(/##.*/, ''), id]),
  ),
);

/** Id of an item of the library by its English name, in any case; null when there is none. */
export function libraryId(name: string): string | null {
  const asked = name.toLowerCase();
  for (const [known, id] of library) if (known.toLowerCase() === asked) return id;
  return null;
}

/** Entries of the Add menu by names that are the same in all languages, such as 'empty', 'Point light', 'box' and 'Street lamp'. */
export function creationNames({ registry, assets }: Scene): {
  readonly names: readonly string[];
  /** @throws Error (as a rejection) for an unknown name; it lists similar names */
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
    names: [...names, ...library.keys()],
    async make(name) {
      const asked = name.toLowerCase();
      const index = names.findIndex((each) => each.toLowerCase() === asked);
      if (index < 0) {
        const alike = [...names, ...library.keys()].filter(
          (each) => each.toLowerCase().includes(asked) || asked.includes(each.toLowerCase()),
        );
        throw new Error(
          `Nothing is called “${name}”${alike.length > 0 ? `; there is ${alike.slice(0, 5).join(', ')}` : ''}. describe_type lists all.`,
        );
      }
      return creations({ registry, assets } as Scene)[index].make();
    },
  };
}
