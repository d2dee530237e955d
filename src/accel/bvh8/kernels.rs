//! Many rays at once through primitives in packs: packets as long as rays are coherent, and waves.

use crate::accel::{Packs, Primitives, Query, Scratch};
use crate::counters::Counters;
use crate::math::Ray;
use crate::simd::{Cache, Kernel, PacketKernel, Row, Simd, dispatch, prefetch};

use super::Bvh8;
use super::diverged::Diverged;
use super::packet::{self, Outcome, Packet};
use super::task::{RayOf, Task};
use super::wave;

/// Rays that are traced together: few enough to stay in a core's cache.
const AT_ONCE: usize = 4096;

/// So many packets before they are traced, rays are asked for. A caller's many rays come from memory, and one packet
/// takes so long that the processor does not see what is read next.
const PACKETS_AHEAD: usize = 4;

/// Answers a query for many rays. The tree needs stacks of less than [`HEIGHT`](super::HEIGHT).
pub(super) fn search<P: Primitives, Q: Query, C: Counters>(
    tree: &Bvh8,
    query: &Q,
    primitives: &P,
    rays: &[Ray],
    answers: &mut [Q::Answer],
    scratch: &mut Scratch,
    counters: &mut C,
) {
    let task = Task::new(tree, query, primitives);
    scratch.lend(|memory, _| dispatch(Search { task, rays, answers, memory, counters }));
}

/// The kernels' memory; `R` is a ray as the primitives' formula takes it.
struct Memory<R> {
    wave: wave::Memory<R>,
    packet: packet::Memory<R>,
    /// Rays that go down in waves from the root, by their place in the slice.
    incoherent: Vec<u32>,
    /// Rays that go on in waves from where their packet diverged.
    diverged: Diverged,
}

impl<R: Copy + Default> Default for Memory<R> {
    fn default() -> Self {
        Self {
            wave: wave::Memory::default(),
            packet: packet::Memory::default(),
            incoherent: Vec::new(),
            diverged: Diverged::default(),
        }
    }
}

/// The search for a slice of rays.
struct Search<'a, P: Primitives, Q: Query, C> {
    task: Task<'a, P, Q>,
    rays: &'a [Ray],
    answers: &'a mut [Q::Answer],
    memory: &'a mut Memory<RayOf<P>>,
    counters: &'a mut C,
}

impl<P: Primitives, Q: Query, C: Counters> Kernel for Search<'_, P, Q, C> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        S::in_packets(self);
    }
}

impl<P: Primitives, Q: Query, C: Counters> PacketKernel for Search<'_, P, Q, C> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd, L: Row<N>, const N: usize>(self) {
        let Self { task, rays, answers, memory, counters } = self;
        for (rays, answers) in rays.chunks(AT_ONCE).zip(answers.chunks_mut(AT_ONCE)) {
            memory.search::<S, L, P, Q, C, N>(&task, rays, answers, counters);
        }
    }
}

impl<R: Copy + Default> Memory<R> {
    /// Rays go down in packets where and as long as they are coherent, and else in waves.
    #[inline(always)]
    fn search<
        S: Simd,
        L: Row<N>,
        P: Primitives<Packs: Packs<Ray = R>>,
        Q: Query,
        C: Counters,
        const N: usize,
    >(
        &mut self,
        task: &Task<'_, P, Q>,
        rays: &[Ray],
        answers: &mut [Q::Answer],
        counters: &mut C,
    ) {
        let Self { wave, packet, incoherent, diverged } = self;
        incoherent.clear();
        diverged.clear();
        packet.start_slice();
        let (packets, rest) = rays.as_chunks::<N>();
        let (of_packets, _) = answers.as_chunks_mut::<N>();
        // One for all packets: it is 3.6 kB, too much to clear or to copy for each.
        let mut lanes = Packet::vacant();
        let mut was_split = false;
        for (number, (rays, answers)) in packets.iter().zip(of_packets).enumerate() {
            let first = (number * N) as u32;
            let numbered = (first, rays);
            // The rays of a wave are asked for as it comes to them.
            if !was_split && let Some(ahead) = packets.get(number + PACKETS_AHEAD) {
                prefetch(ahead, Cache::Second);
            }
            was_split = in_several_octants(rays, was_split);
            if was_split
                || packet::search::<S, L, P, Q, C, false, N>(
                    task, numbered, &mut lanes, answers, packet, diverged, counters,
                ) == Outcome::Incoherent
            {
                incoherent.extend(first..first + N as u32);
            }
        }
        incoherent.extend((rays.len() - rest.len()) as u32..rays.len() as u32);
        let waiting = (&incoherent[..], &*diverged);
        dispatch(Waves { task, rays, waiting, answers, wave, counters });
    }
}

/// Whether directions of some of the rays differ in a sign. Such rays make no packet, and a few of them tell most. More
/// of them are asked `closely`, which costs coherent rays time, and spares others a packet that is in vain.
#[inline(always)]
fn in_several_octants<const N: usize>(rays: &[Ray; N], closely: bool) -> bool {
    let signs = |ray: usize, axis: usize| {
        rays[ray * (N - 1) / 6].dir[axis].to_bits() ^ rays[0].dir[axis].to_bits()
    };
    let differ = |ray: usize| signs(ray, 0) | signs(ray, 1) | signs(ray, 2);
    let by_few = (differ(2) | differ(4) | differ(6)) >> 31 != 0;
    by_few || closely && (differ(1) | differ(3) | differ(5)) >> 31 != 0
}

/// The search for rays that do not make packets: compiled by itself, because constants of packets' lanes
/// in the same function would keep a processor's second unit for eight lanes from work (Intel).
struct Waves<'a, P: Primitives, Q: Query, C> {
    task: &'a Task<'a, P, Q>,
    rays: &'a [Ray],
    waiting: (&'a [u32], &'a Diverged),
    answers: &'a mut [Q::Answer],
    wave: &'a mut wave::Memory<RayOf<P>>,
    counters: &'a mut C,
}

impl<P: Primitives, Q: Query, C: Counters> Kernel for Waves<'_, P, Q, C> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { task, rays, waiting, answers, wave, counters } = self;
        wave::search::<S, P, Q, C>(task, rays, waiting, answers, wave, counters);
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    #[test]
    fn rays_are_of_several_octants_if_a_few_of_them_are_or_a_few_more_asked_closely() {
        let ahead = [Ray::new(Vec3::ZERO, Vec3::ONE); 32];
        assert!(!in_several_octants(&ahead, true));
        let (mut by_few, mut by_more) = (0, 0);
        for (turned, axis) in (0..32).flat_map(|turned| (0..3).map(move |axis| (turned, axis))) {
            let mut rays = ahead;
            rays[turned].dir[axis] = -1.0;
            let (few, more) = (in_several_octants(&rays, false), in_several_octants(&rays, true));
            assert!(more || !few);
            by_few += usize::from(few);
            by_more += usize::from(more);
        }
        assert_eq!((by_few, by_more), (3 * 4, 3 * 7));
        let smaller = [Ray::new(Vec3::ZERO, Vec3::NEG_ONE); 16];
        assert!(!in_several_octants(&smaller, true));
    }
}
