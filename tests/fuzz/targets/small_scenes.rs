//! Bytes → a small scene, all structures over it, and rays: each gives the answers of `none`, bit for bit.
#![no_main]

use std::sync::OnceLock;

use libfuzzer_sys::fuzz_target;
use srt::accel::{Allowed, Answers, BuildConfig, Quality, Scratch, Tracer};
use srt::conformance::adversarial_rays::{bundles_around, rays_cut_at_hits};
use srt::counters::Counts;
use srt::math::{Hit, Ray};
use srt::scene::{STRUCTURES, Scene, Structure};
use srt_fuzz::small_scene::{SmallScene, takes};

/// How many of the rays are also made bundles of.
const BUNDLES: usize = 2;

fuzz_target!(
    init: {
        srt_fuzz::work_on_this_thread();
        choices();
    },
    |data: &[u8]| {
        let Some(SmallScene { scene, mut rays, choice }) = SmallScene::new(data) else { return };
        let bundles = bundles_around(&rays[..rays.len().min(BUNDLES)]);
        rays.extend(bundles.into_iter().filter(|ray| takes(&scene, ray)));
        let traced = check(&scene, rays, choice);
        srt_fuzz::count(traced);
    }
);

/// Compares all structures with `none`; whether anything was hit.
fn check(scene: &Scene, mut rays: Vec<Ray>, choice: u8) -> bool {
    let none = STRUCTURES[0].build(scene, &BuildConfig::default());
    let (hits, _) = in_slices(none.as_ref(), &rays, rays.len());
    rays.extend(rays_cut_at_hits(&rays, &hits).into_iter().filter(|ray| takes(scene, ray)));
    let expected = in_slices(none.as_ref(), &rays, rays.len());
    rays.iter().zip(&expected.0).zip(&expected.1).for_each(|((ray, hit), &blocked)| {
        check_hit(scene, ray, hit, blocked);
    });
    let quality = Quality::ALL[usize::from(choice) % Quality::ALL.len()];
    let config = BuildConfig { quality, ..BuildConfig::default() };
    // Alone, or as many as fill no packet; and all at once.
    let lengths = [[1, 5][usize::from(choice) / 128], rays.len()];
    for structure in &choices()[usize::from(choice) % choices().len()] {
        let world = structure.build(scene, &config);
        for length in lengths {
            let answers = in_slices(world.as_ref(), &rays, length);
            assert_equal(structure, quality, length, &rays, &answers, &expected);
        }
    }
    expected.1.contains(&true)
}

/// The structures of the table but `none`: without options, and then with the first values of all options, the second
/// ones, and so on.
fn choices() -> &'static [Vec<Structure>] {
    static CHOICES: OnceLock<Vec<Vec<Structure>>> = OnceLock::new();
    let with_options = |structure: &Structure, number: usize| {
        let options = structure.offered_options().map(|option| match option.allowed {
            Allowed::Words(words) => format!("{}={}", option.name, words[number % words.len()]),
            Allowed::Numbers(least, most) => {
                let numbers = [least, least.midpoint(most), most];
                format!("{}={}", option.name, numbers[number % numbers.len()])
            }
        });
        let text = options.collect::<Vec<_>>().join(",");
        if text.is_empty() { *structure } else { structure.with_options(&text).expect("offered") }
    };
    CHOICES.get_or_init(|| {
        let others = &STRUCTURES[1..];
        let chosen = (0..6).map(|number| others.iter().map(|s| with_options(s, number)).collect());
        std::iter::once(others.to_vec()).chain(chosen).collect()
    })
}

/// The answers to all rays, so many at a time.
fn in_slices(tracer: &dyn Tracer, rays: &[Ray], length: usize) -> (Vec<Hit>, Vec<bool>) {
    let (mut hits, mut blocked) = (vec![Hit::MISS; rays.len()], vec![false; rays.len()]);
    let (mut scratch, mut counts) = (Scratch::default(), Counts::default());
    let length = length.max(1);
    let slices = rays.chunks(length).zip(hits.chunks_mut(length)).zip(blocked.chunks_mut(length));
    for (number, ((rays, hits), blocked)) in slices.enumerate() {
        // Counting is compiled apart, and must find the same.
        let counted = number % 3 == 1;
        tracer.trace(rays, Answers::ClosestHit(hits), &mut scratch, counted.then_some(&mut counts));
        tracer.trace(rays, Answers::AnyHit(blocked), &mut scratch, counted.then_some(&mut counts));
    }
    (hits, blocked)
}

/// What stands for any hit: it is of an object that is there, within the ray's interval, and blocks it.
fn check_hit(scene: &Scene, ray: &Ray, hit: &Hit, blocked: bool) {
    assert_eq!(hit.is_hit(), blocked, "{ray:?}: the closest hit is {hit:?}");
    if blocked {
        assert!((hit.object as usize) < scene.objects.len(), "{ray:?}: {hit:?}");
        assert!(hit.t >= ray.t_min && hit.t <= ray.t_max, "{ray:?}: {hit:?}");
    } else {
        assert!(hit.same_bits(&Hit::MISS), "{ray:?}: {hit:?}");
    }
}

fn assert_equal(
    structure: &Structure,
    quality: Quality,
    length: usize,
    rays: &[Ray],
    (hits, blocked): &(Vec<Hit>, Vec<bool>),
    (expected_hits, expected_blocked): &(Vec<Hit>, Vec<bool>),
) {
    for (i, ray) in rays.iter().enumerate() {
        let equal = hits[i].same_bits(&expected_hits[i]) && blocked[i] == expected_blocked[i];
        assert!(
            equal,
            "{} built {}, {length} rays at a time, number {i}: {ray:?}\n  got      {:?} {}\n  expected {:?} {}",
            structure.name,
            quality.name(),
            hits[i],
            blocked[i],
            expected_hits[i],
            expected_blocked[i],
        );
    }
}
