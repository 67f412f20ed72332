import { shortText } from '@farol/editing';

/** Greatest number of names listed in a message. */
const LISTED = 12;

/** Names of files and materials in a message, shortened. */
export const listed = (names: Iterable<string>): string => {
  const all = [...names];
  const more = all.length > LISTED ? ` and ${all.length - LISTED} more` : '';
  return (
    all
      .slice(0, LISTED)
      .map((name) => shortText(name.replaceAll('\\', '/'), 60))
      .join(', ') + more
  );
};
