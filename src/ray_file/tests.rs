use glam::Vec3;
use sha2::{Digest, Sha256};

use super::*;

fn rays(count: usize) -> Vec<Ray> {
    let ray = |i: usize| {
        let x = i as f32;
        Ray::with_interval(Vec3::new(x, -0.0, 1e-40), Vec3::new(0.0, -x, 1e20), 0.0, 1e6 + x)
    };
    (0..count).map(ray).collect()
}

fn example() -> RayFile {
    let hit = Hit { t: 0.5, object: 3, prim: 7, u: 0.25, v: -0.0 };
    let closest = RayAnswers::ClosestHit(vec![hit, Hit::MISS, hit]);
    let any = RayAnswers::AnyHit(vec![true, false]);
    let mut endless = rays(2);
    endless[1].t_max = f32::INFINITY;
    RayFile {
        geometry: std::array::from_fn(|i| i as u8),
        classes: vec![
            ClassRays { class: RayClass::View, rays: rays(3), answers: closest },
            ClassRays { class: RayClass::Shadow, rays: endless, answers: any },
        ],
    }
}

/// The bytes with a change, and the hash of what they are then: what only somebody on purpose would write.
fn forged(change: impl FnOnce(&mut Vec<u8>)) -> Result<RayFile, RayFileError> {
    let mut bytes = example().encode();
    bytes.truncate(bytes.len() - 32);
    change(&mut bytes);
    let hash = Sha256::digest(&bytes);
    bytes.extend(hash);
    RayFile::decode(&bytes)
}

#[test]
fn a_file_reads_back_bit_for_bit() {
    let file = example();
    let bytes = file.encode();
    assert_eq!(bytes.len(), 56 + 2 * 16 + 3 * (32 + 20) + 2 * (32 + 1) + 32);
    let again = RayFile::decode(&bytes).unwrap();
    assert_eq!((again.encode(), again.hash()), (bytes.clone(), file.hash()));
    assert_eq!(bytes[bytes.len() - 32..], file.hash());
    let classes = again.classes.iter().map(|own| (own.class, own.answers.hit_count()));
    assert_eq!(classes.collect::<Vec<_>>(), [(RayClass::View, 2), (RayClass::Shadow, 1)]);
    let none = RayFile::default();
    assert_eq!(RayFile::decode(&none.encode()).unwrap(), none);
}

#[test]
fn the_codes_of_classes_stay_what_they_are() {
    let names = RayClass::ALL.map(RayClass::name);
    assert_eq!(names, ["view", "shadow", "mirror", "refraction", "diffuse", "random", "probe"]);
    for (class, code) in RayClass::ALL.into_iter().zip(0..) {
        let answers = RayAnswers::AnyHit(vec![]);
        let file =
            RayFile { classes: vec![ClassRays { class, rays: vec![], answers }], ..example() };
        assert_eq!(file.encode()[56], code);
    }
}

#[test]
fn every_altered_byte_and_every_other_length_is_refused() {
    let bytes = example().encode();
    for place in 0..bytes.len() {
        let mut altered = bytes.clone();
        altered[place] ^= 0x10;
        RayFile::decode(&altered).expect_err("an altered byte");
        RayFile::decode(&bytes[..place]).expect_err("a part of a file");
    }
    let longer = [&bytes[..], &[0]].concat();
    let error = RayFile::decode(&longer).unwrap_err();
    let (found, expected) = (longer.len() as u64, bytes.len() as u64);
    assert_eq!(error, RayFileError::Length { expected, found });
    let mut altered = bytes;
    altered[150] ^= 1;
    let error = RayFile::decode(&altered).unwrap_err().to_string();
    assert!(error.contains("SHA-256") && error.ends_with("it was altered"), "{error}");
}

#[test]
fn counts_that_no_memory_holds_are_refused_before_any_is_taken() {
    let error = forged(|bytes| bytes[64..72].fill(0xff)).unwrap_err();
    let total = u64::MAX;
    assert!(matches!(error, RayFileError::Length { expected, .. } if expected == total), "{error}");
    let error = forged(|bytes| bytes[12..16].fill(0xff)).unwrap_err();
    assert!(matches!(error, RayFileError::Length { .. }), "{error}");
}

#[test]
fn what_is_impossible_is_named() {
    let data = 56 + 32;
    let text =
        |change: &dyn Fn(&mut Vec<u8>)| forged(|bytes| change(bytes)).unwrap_err().to_string();
    let set = |at: usize, value: [u8; 4]| {
        move |bytes: &mut Vec<u8>| bytes[at..at + 4].copy_from_slice(&value)
    };
    assert!(text(&set(0, *b"obj ")).starts_with("it does not begin with `srt-rays`"));
    assert!(text(&set(8, [9, 0, 0, 0])).starts_with("it has version 9 of the form"));
    let calls = "bytes 48 to 51 have 8, where version 1 of the form has 1024";
    assert_eq!(text(&set(48, [8, 0, 0, 0])), calls);
    assert!(text(&|bytes| bytes[55] = 1).starts_with("bytes 52 to 55 have 16777216, where"));
    assert_eq!(text(&|bytes| bytes[56] = 7), "class 1 of its table has an unknown class: 7");
    assert_eq!(text(&|bytes| bytes[73] = 2), "class 2 of its table has an unknown query: 2");
    assert!(
        text(&|bytes| bytes[60] = 1).starts_with("class 1 of its table has an unknown meaning")
    );
    assert_eq!(text(&|bytes| bytes[72] = 0), "its table has the class `view` twice");
    let nan = f32::NAN.to_le_bytes();
    assert!(text(&set(data + 32, nan)).starts_with("view ray 1 cannot be traced: the origin"));
    let early = text(&set(data + 12, (-1f32).to_le_bytes()));
    assert!(early.starts_with("view ray 0 cannot be traced: the ray's interval"), "{early}");
    let answers = data + 3 * 32;
    let late = text(&set(answers, 1e7f32.to_le_bytes()));
    assert_eq!(
        late,
        "the answer of view ray 0 is impossible: its t is outside of the ray's interval"
    );
    assert!(text(&set(answers + 24, [0; 4])).starts_with("the answer of view ray 1 is impossible"));
    assert!(text(&set(answers + 12, nan)).contains("not finite"));
    let last = |bytes: &mut Vec<u8>| *bytes.last_mut().unwrap() = 2;
    assert_eq!(text(&last), "the answer of shadow ray 1 is impossible: it is neither 0 nor 1");
}

#[test]
fn rodents_rays_are_six_numbers_each() {
    let cut = |ray: Ray| Ray { t_min: 0.25, t_max: 9.0, ..ray };
    let rays: Vec<Ray> = rays(5).into_iter().map(cut).collect();
    let (bytes, interval) = rodent::encode(&rays).unwrap();
    assert_eq!((bytes.len(), interval), (5 * 24, [0.25, 9.0]));
    assert_eq!(bytes[24..28], 1f32.to_le_bytes());
    assert_eq!(rodent::decode(&bytes, interval).unwrap(), rays);
    assert_eq!(rodent::encode(&[]).unwrap(), (vec![], [0.0, f32::MAX]));
    let several = rodent::encode(&self::rays(2)).unwrap_err().to_string();
    assert!(
        several.starts_with("ray 1 has the interval from 0 to 1000001, and the first"),
        "{several}"
    );
    assert_eq!(
        rodent::decode(&bytes[1..], interval).unwrap_err(),
        rodent::RodentError::Length { found: 119 }
    );
    let error = rodent::decode(&[0xff; 24], interval).unwrap_err();
    assert!(error.to_string().starts_with("ray 0 cannot be traced: the origin"), "{error}");
    assert!(rodent::decode(&bytes, [0.0, f32::NAN]).is_err());
}

#[test]
fn tinybvhs_rays_are_64_bytes_each() {
    let rays = rays(3);
    let bytes = tinybvh::encode(&rays).unwrap();
    assert_eq!(bytes.len(), 3 * 64);
    let number = |at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let second: Vec<f32> =
        [64, 64 + 20, 64 + 24, 64 + 32, 64 + 36, 64 + 40, 64 + 48].map(number).into();
    assert_eq!(second, [1.0, -1.0, 1e20, 1e30, -1.0, 1e-20, 1_000_001.0]);
    assert_eq!(bytes[76..80], [0xff, 0xff, 0, 0]);
    assert_eq!(tinybvh::decode(&bytes).unwrap(), rays);
    let late = Ray { t_min: 0.5, ..rays[0] };
    assert_eq!(
        tinybvh::encode(&[rays[0], late]).unwrap_err(),
        tinybvh::TinyBvhError::Begin { index: 1, t_min: 0.5 }
    );
    assert!(tinybvh::decode(&bytes[..65]).unwrap_err().to_string().contains("no multiple of 64"));
    let error = tinybvh::decode(&[0xff; 64]).unwrap_err();
    assert!(error.to_string().starts_with("ray 0 cannot be traced"), "{error}");
}
