/** Whether this player contains the renderer's particles; set to false in the build for scenes without any. */
export const hasParticles: boolean = true;
