/** Whether this player has the renderer's particles; the build says no for that of scenes without any. */
export const hasParticles: boolean = true;
